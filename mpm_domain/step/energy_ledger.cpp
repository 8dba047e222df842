#include "mpm_domain/step/energy_ledger.hpp"

namespace tremolo::mpm_domain {

std::array<double, 9> EnergyLedger::row() const {
  return {kinetic, elastic, plastic, gravity, input, static_, dashpots, transfer, residual()};
}

} // namespace tremolo::mpm_domain
