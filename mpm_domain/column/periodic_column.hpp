#pragma once

// A free field with the domain's own discretisation: a periodic domain one cell wide, shaken through its base
// by the incident wave, Eqs. (4) and (5) of the method. Where a flat domain has the same cells, particles and
// time step, its side faces find at their own places the very velocity and stress that the domain has inside.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/step/stepper.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// The incident wave alone at the level of the base: velocity and stress at a time, s.
using IncidentWave = std::function<eq6::FreeField(double time)>;

struct PeriodicColumnSpec {
  Spec domain;                      ///< one cell wide; its sides become periodic
  materials::Elasticity half_space; ///< what the base's dashpots match
  IncidentWave incident;
  double start_time = 0.0; ///< s
  double time_step = 0.0;  ///< s, between two served states
};

/// Motion at one level: the state at the column's present time and its time derivative.
struct ColumnPoint {
  Vector velocity;         ///< m/s
  Vector acceleration;     ///< m/s2
  eq6::Stress stress;      ///< dynamic part, Pa
  eq6::Stress stress_rate; ///< Pa/s
};

/// The column, served at a constant interval. Where its soil, whose stiffness may grow with pressure, needs
/// shorter steps, an interval is cut into equal ones.
class PeriodicColumn {
public:
  /// The column is at rest at the start time, under gravity if there is any.
  /// @throws std::invalid_argument for a spec that cannot be built
  explicit PeriodicColumn(PeriodicColumnSpec spec);

  void step();

  double time() const { return time_; }
  double time_step() const { return spec_.time_step; }
  /// Base, the centres of the particles, surface; ascending, m.
  const std::vector<double>& levels() const { return levels_; }
  /// One a level.
  std::span<const ColumnPoint> points() const { return points_; }

private:
  /// Goes one interval ahead: the state at a time is known when the step from it has been made.
  void advance();
  /// The state at the present time, after the step from it.
  void record(const std::vector<eq6::Stress>& after);
  /// Cuts the interval so that its parts are stable; returns their number.
  int cut_interval();
  void sample_velocities(std::vector<Vector>& v, bool accelerations) const;
  /// The stress of the law and that of viscous damping.
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
  long intervals_ = 0;
  double time_ = 0.0;
  double previous_dt_ = 0.0; ///< of the step before the present time, s
};

} // namespace tremolo::mpm_domain
