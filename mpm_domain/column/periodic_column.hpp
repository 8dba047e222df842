#pragma once

// A free field with the domain's own discretisation: a periodic domain one cell wide, shaken through its base
// by the incident wave, Eqs. (4) and (5) of the method. Where a flat domain has the same cells, particles and
// time step, its side faces find at their own positions the very velocity and stress that the domain has
// inside.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/step/stepper.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
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
  /// Between two served states, s; without it the step that the scheme takes in the soil at rest.
  std::optional<double> time_step;
};

/// Motion at one level: the state at the column's present time and its time derivative.
struct ColumnPoint {
  Vector velocity;         ///< m/s, of grains and water together: what dashpots beside it see
  Vector acceleration;     ///< m/s2
  eq6::Stress stress;      ///< dynamic part, total where there is pore water, Pa
  eq6::Stress stress_rate; ///< Pa/s
  Vector displacement;     ///< since the start, m
  double eyy = 0.0;        ///< strain: duy/dy
  double gxy = 0.0;        ///< dux/dy
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
  double time_step() const { return *spec_.time_step; }
  /// Base, the centres of the particles, surface; ascending, m.
  const std::vector<double>& levels() const { return levels_; }
  /// One a level.
  std::span<const ColumnPoint> points() const { return points_; }
  /// Excess over the hydrostatic pressure at a level (m), Pa: linear between the centres of cells, whose mean
  /// it is, and to zero at the water table, which is drained unless the soil there lets no water through.
  double pore_pressure_at(double y) const;
  long steps() const { return stepper_->steps(); }
  /// The ledger of the whole column, one cell wide, J/m.
  const EnergyLedger& energy() const { return domain_.energy; }

private:
  /// State of a row's particle.
  struct Row {
    eq6::Stress stress; ///< of law, viscous damping and excess pore pressure
    Vector displacement;
    double pore_pressure = 0.0; ///< excess, Pa
  };

  /// The wet rows of a cell.
  struct WetCell {
    std::size_t first_row = 0;
    std::size_t end_row = 0;
    double y = 0.0;             ///< of their centre, m
    double pore_pressure = 0.0; ///< at the present time, Pa
  };

  void find_wet_cells();
  /// Goes one interval ahead: the state at a time is known when the step from it has been made.
  void advance();
  /// The state at the present time, after the step from it.
  void record(const std::vector<Row>& after);
  /// Displacements, strains and pore pressures at the present time.
  void record_deformation();
  /// Cuts the interval so that its parts are stable; returns their number.
  int cut_interval();
  /// Numbers of nodes, of_node(node), at the levels.
  template <typename OfNode>
  void sample_nodes(std::vector<Vector>& v, const OfNode& of_node) const;
  /// The velocities at the present time, from those before and after the update.
  void find_velocities();
  std::vector<Row> rows() const;

  PeriodicColumnSpec spec_;
  Domain domain_;
  std::unique_ptr<Stepper> stepper_;
  std::vector<std::uint32_t> ids_; ///< of one particle a row, upwards
  std::vector<std::size_t> sets_;  ///< and its soil
  std::vector<double> levels_;
  std::vector<ColumnPoint> points_;
  std::vector<WetCell> wet_cells_; ///< upwards
  std::vector<Row> at_rest_, before_, now_;
  std::vector<Vector> velocity_before_; ///< of the grid before the update, one a level
  std::vector<Vector>
      velocity_kicked_;      ///< after the last update where there is water; empty before the first
  Vector base_displacement_; ///< at the present time, m
  long intervals_ = 0;
  double time_ = 0.0;
  double previous_dt_ = 0.0; ///< of the step before the present time, s
};

} // namespace tremolo::mpm_domain
