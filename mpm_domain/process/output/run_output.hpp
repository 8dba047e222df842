#pragma once

#include "mpm_domain/boundary/drift/lost_hold.hpp"
#include "mpm_domain/process/output/body_output.hpp"
#include "mpm_domain/process/output/followed_point.hpp"
#include "mpm_domain/process/output/lining_output.hpp"
#include "mpm_domain/process/output/prop_output.hpp"
#include "mpm_domain/process/output/section_output.hpp"
#include "mpm_domain/process/output/sliding_mass_output.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "results/checkpoint_file.hpp"
#include "results/run_file.hpp"
#include "scene/case.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// Writes a run's file as the case asks: monitors, lines, sliding masses, linings, props, sections, energy,
/// particle frames, boundary exchange, timings.
///
/// Everything written belongs to the time of the particle velocities, Stepper::time_of_soil(): displacements
/// are taken back by v dt/2 to it; accelerations lie half a step before it, stresses half a step after.
class RunOutput {
public:
  /// Creates DIR/run.h5 for a domain at the start of shaking; particles that monitors follow stay whole.
  /// @param start     the particles of the domain, or as many of them as output looks for
  ///                  (ranks/particles_at_start.hpp)
  /// @param snapshot  what is written of the particles; it and the domain outlive this
  RunOutput(const std::filesystem::path& directory, const scene::Case& scene, const std::string& plan,
            Domain& domain, std::span<const Particles> start, const Snapshot& snapshot,
            std::span<const std::string> face_sources);

  /// The particles that have histories; those of sliding masses are not among them.
  const std::vector<ParticleName>& followed() const { return followed_; }
  /// Fields of the snapshot that are needed after a step, and at the end.
  Snapshot::Extent needs(const Stepper& stepper) const;
  Snapshot::Extent needs_to_finish(const Stepper& stepper) const;

  /// Called after every step; writes what is due.
  void after_step(const Stepper& stepper);

  /// Writes a domain that has not been shaken, as a frame at time 0, with the forces of props. Contact has no
  /// forces yet.
  void write_before_shaking(const Stepper& stepper) {
    write_frame(stepper, 0.0, {});
    props_.write_history(stepper);
  }

  /// Writes the last state, unless that has been done.
  void write_last(const Stepper& stepper);

  /// Writes the timings, and closes the file as complete.
  /// @return what is still missing from the file, as a sentence
  std::optional<std::string> finish(const Stepper& stepper, double gravity_seconds, double waiting_seconds);

  /// A sentence with what the user should be warned of after the run, if anything.
  std::optional<std::string> warning() const;
  /// A sentence on how far sides and base have moved, for information only.
  std::optional<std::string> note() const;

  /// Writes the state that a continued output needs besides the present file.
  void save(results::CheckpointWriter& checkpoint);
  /// Goes on from there in a new file: takes over what the file before held then.
  void take_over(const std::filesystem::path& before, const results::CheckpointReader& checkpoint);

  /// Closes the file with the reason why the run ended early.
  void abort(const std::string& reason) { writer_.abort(reason); }

private:
  /// A monitor in soil, or in an elastic structure; or a line.
  struct Followers {
    std::string path;
    std::vector<FollowedPoint> points;
    results::TimeSeries* series = nullptr;
  };

  /// State that the output keeps from row to row.
  SavedNumbers state();
  void add_monitors(std::span<const Particles> start);
  void add_lines(std::span<const Particles> start);
  /// Adds the series of one point, or of several, whose columns are then numbered.
  void add_followers(const std::string& path, const std::vector<FollowedPoint>& points,
                     std::span<const results::Attribute> attributes, bool numbered);
  void take_over_histories(const results::RunReader& before, std::size_t rows, std::size_t frames);
  void take_over_frame(const results::RunReader& before, std::size_t frame);
  void write_history(const Stepper& stepper);
  void write_frame(const Stepper& stepper, double time, const ContactFrame& contact);
  void write_boundary(const Stepper& stepper);

  const scene::Case& scene_;
  Domain& domain_;
  const Snapshot& snapshot_;
  results::RunWriter writer_;
  BodyOutput bodies_;
  LiningOutput linings_;
  PropOutput props_;
  SectionOutput sections_;
  SlidingMassOutput sliding_masses_;
  LostHold lost_hold_;
  results::TimeSeries* energy_ = nullptr;
  results::TimeSeries* table_ = nullptr; ///< motion of a shaking table
  std::vector<Followers> followers_;
  std::vector<ParticleName> followed_;
  double next_history_ = 0.0;
  double next_frame_ = 0.0;
  double last_history_ = 0.0; ///< times of what was written last
  double last_frame_ = 0.0;
  std::uint64_t history_rows_ = 0;
};

} // namespace tremolo::mpm_domain
