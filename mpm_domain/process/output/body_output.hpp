#pragma once

#include "mpm_domain/domain.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "results/run_file.hpp"
#include "scene/case.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

/// Fields of a frame's contact nodes, node after node, body after body.
struct ContactFrame {
  std::vector<double> position, normal;
  std::vector<double> area, normal_force, friction_force, water_force;
  std::vector<std::int32_t> body;

  /// They refer to the arrays.
  std::vector<results::Field> fields() const;
};

/// The part of a run's file about structures: a series a body, one a monitor that moves with a rigid
/// one, and, frame by frame, outlines of elastic ones and contact nodes. Everything belongs to the times that
/// RunOutput names.
class BodyOutput {
public:
  /// Adds the series to the file.
  BodyOutput(const scene::Case& scene, const Domain& domain, results::RunWriter& writer);

  /// Finds accelerations; to be called after every step.
  void after_step(const Stepper& stepper);

  /// Writes a row of each series.
  void write_history(const Stepper& stepper);

  /// Writes a row of each outline, for a frame.
  void write_outlines(const Stepper& stepper);

  bool any() const { return !bodies_.empty(); }
  /// The contact nodes of the step just made.
  ContactFrame contact(const Stepper& stepper) const;

  /// The followers' velocities, for a checkpoint.
  void add_state(SavedNumbers& state);

  /// Series with a row in each row of the histories, by their paths.
  const std::vector<std::pair<std::string, results::TimeSeries*>>& series() const { return series_; }
  /// Series with a row in each frame.
  const std::vector<std::pair<std::string, results::TimeSeries*>>& outlines() const { return outlines_; }

private:
  /// A monitor that moves with a rigid body.
  struct Follower {
    std::size_t body = 0;
    Vector arm;          ///< from the centre of mass before any tilt, m
    Vector velocity;     ///< after the last step, m/s
    Vector acceleration; ///< half a step before, m/s2
    results::TimeSeries* series = nullptr;
  };

  void add_outline(std::size_t body, results::RunWriter& writer);
  void write_body(std::size_t body, const Stepper& stepper);
  void write_follower(const Follower& follower, const Stepper& stepper);

  const Domain& domain_;
  std::vector<results::TimeSeries*> bodies_; ///< in the order of Contact::bodies()
  std::vector<Follower> followers_;
  std::vector<std::pair<std::string, results::TimeSeries*>> series_;
  std::vector<std::pair<std::string, results::TimeSeries*>> outlines_; ///< of elastic bodies
};

} // namespace tremolo::mpm_domain
