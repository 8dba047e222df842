#pragma once

#include "freefield/ode/ode_column.hpp"
#include "freefield/ode/ode_grid.hpp"
#include "freefield/ode/ode_integrator.hpp"
#include "freefield/ode/ode_system.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace tremolo::freefield {

/// One polarisation of the column: its equations, what integrates them, and the state that is served. Nothing
/// is integrated before its input is first other than zero.
class OdePolarisation {
public:
  /// @param impedance  rho c of the half-space, Pa s/m
  /// @param cells, soil  of the grid, from the base up
  OdePolarisation(StaggeredGrid grid, std::vector<OdeCell> cells, OdeBase base, OdeSoil soil,
                  const OdeColumnSettings& settings);

  /// Makes the state at a time, not before the last one, the state that is sampled.
  /// @throws std::runtime_error if it cannot be reached
  void serve(double time);

  struct Sample {
    double velocity = 0.0, acceleration = 0.0; ///< m/s, m/s2
    double stress = 0.0, stress_rate = 0.0;    ///< Pa, Pa/s
    double displacement = 0.0;                 ///< m
    double strain = 0.0;
    std::size_t layer = 0; ///< in which the level lies
  };
  Sample at(double y, ColumnMesh::Side side) const;

  const ColumnMesh& mesh() const { return grid_.mesh; }
  OdeStatistics statistics() const { return integrator_ ? integrator_->statistics() : OdeStatistics{}; }

private:
  bool is_at_rest_until(double time);
  double strain_at(const ColumnMesh::Place& place, double y) const;

  StaggeredGrid grid_;
  std::vector<OdeCell> cells_;
  OdeSystem system_;
  OdeColumnSettings settings_;
  std::unique_ptr<OdeIntegrator> integrator_; ///< nothing while at rest
  long quiet_ = 0;                            ///< looks at the input that found it zero
  double time_;
  std::vector<double> state_, rate_;
  std::vector<double> displacement_; ///< of the nodes, m
};

} // namespace tremolo::freefield
