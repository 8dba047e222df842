#include "mpm_domain/passes/step.hpp"

namespace tremolo::mpm_domain {

Step::Step(Ground& at_rest, EnergyLedger& ledger, double start_time)
    : ground(at_rest), time(start_time), ticks(ground.clocks.count()), nodes(ground),
      shared(ground, ticks, nodes), energy(ledger), bookings(ground.share ? ground.share->ranks : nullptr),
      kicks(static_cast<std::size_t>(ticks.clocks())), kinetic(kicks.size()), remap_power(kicks.size()) {}

Step::~Step() = default;

void Step::book_transfer(double duration, const ExactSums<1>& power) {
  bookings.add(power, [this, duration](const auto& total) { energy.transfer += duration * total[0]; });
}

} // namespace tremolo::mpm_domain
