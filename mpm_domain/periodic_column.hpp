#pragma once

// A free field with the domain's own discretisation: a periodic domain one cell wide, shaken through its base
// by the incident wave, Eqs. (4) and (5) of the method. Where a flat domain has the same cells, particles and
// time step, its side faces find at their own places the very velocity and stress that the domain has inside.

#include "mpm_domain/gravity_stage.hpp"
#include "mpm_domain/stepper.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// The incident wave alone at the level of the base: velocity and stress at a time, s.
using IncidentWave = std::function<eq6::FreeField(double time)>;

struct PeriodicColumnSpec {
  Spec domain;                      ///< one cell wide, with a fixed time step; its sides become periodic
  materials::Elasticity half_space; ///< what the base's dashpots match
  IncidentWave incident;
  double start_time = 0.0; ///< s
};

/// Motion at one level: the state at the column's present time and its time derivative.
struct ColumnPoint {
  Vector velocity;         ///< m/s
  Vector acceleration;     ///< m/s2
  eq6::Stress stress;      ///< dynamic part, Pa
  eq6::Stress stress_rate; ///< Pa/s
};

/// The column, marched in time by the fixed step of its domain.
class PeriodicColumn {
public:
  /// At rest under gravity, if there is any, at the start time.
  /// @throws std::invalid_argument for a spec that cannot be built or has no fixed time step
  explicit PeriodicColumn(PeriodicColumnSpec spec);

  void step();

  double time() const { return time_; }
  double time_step() const { return stepper_->dt(); }
  /// Base, the centres of the particles, surface; ascending, m.
  const std::vector<double>& levels() const { return levels_; }
  /// One a level.
  std::span<const ColumnPoint> points() const { return points_; }

private:
  /// Goes one step ahead: the state at a time is known when the step from it has been made.
  void advance();
  void sample_velocities(std::vector<Vector>& v, bool accelerations) const;
  std::vector<eq6::Stress> stresses() const;

  PeriodicColumnSpec spec_;
  Domain domain_;
  std::unique_ptr<Stepper> stepper_;
  std::vector<std::uint32_t> ids_; ///< of one particle a row, upwards
  std::vector<std::size_t> sets_;  ///< and its soil
  std::vector<double> levels_;
  std::vector<ColumnPoint> points_;
  std::vector<eq6::Stress> at_rest_, before_, now_; ///< of the particles
  std::vector<Vector> velocity_before_;             ///< of the grid before the update, one a level
  double time_ = 0.0;
};

} // namespace tremolo::mpm_domain
