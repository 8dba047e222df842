#pragma once

#include "freefield/ode/ode_column.hpp"
#include "freefield/ode/ode_system.hpp"

#include <memory>
#include <span>
#include <vector>

namespace tremolo::freefield {

/// CVODE or ARKODE behind one face: steps with error control, and a dense output over the last of them.
class OdeIntegrator {
public:
  /// Starts at rest.
  /// @param absolute_tolerance  one a state variable
  /// @param level  y of each state variable, m, for messages
  OdeIntegrator(OdeSystem& system, const OdeColumnSettings& settings, std::vector<double> absolute_tolerance,
                std::vector<double> level);
  ~OdeIntegrator();

  /// Takes the state into the history of the soil and makes one step.
  /// @throws std::runtime_error with time and level if the integrator gives up
  void step();

  double time() const; ///< of the last step's end, s

  /// State or its derivative of `order` 1 at a time within the last step.
  void state(double time, int order, std::span<double> y) const;

  OdeStatistics statistics() const;

private:
  struct Sundials;
  std::unique_ptr<Sundials> sundials_;
};

} // namespace tremolo::freefield
