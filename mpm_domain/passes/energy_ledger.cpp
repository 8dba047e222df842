#include "mpm_domain/passes/energy_ledger.hpp"

namespace tremolo::mpm_domain {

std::array<double, energy_columns.size()> EnergyLedger::row() const {
  return {kinetic, elastic, plastic, viscous, pore,     drag,     friction,  impact,
          springs, gravity, input,   static_, dashpots, transfer, residual()};
}

std::vector<double> EnergyLedger::state() const {
  return {kinetic_start, kinetic, elastic, plastic, viscous, pore,     drag,    friction,
          impact,        springs, gravity, input,   static_, dashpots, transfer};
}

void EnergyLedger::set_state(const std::vector<double>& state) {
  auto next = state.begin();
  for (double* entry : {&kinetic_start, &kinetic, &elastic, &plastic, &viscous, &pore, &drag, &friction,
                        &impact, &springs, &gravity, &input, &static_, &dashpots, &transfer})
    *entry = *next++;
}

} // namespace tremolo::mpm_domain
