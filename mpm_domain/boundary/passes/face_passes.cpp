#include "mpm_domain/boundary/passes/passes.hpp"
#include "mpm_domain/ground.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

void book_faces(Boundary& boundary, Step& step) {
  step.bookings.add(boundary.follow_update(step), [&energy = step.energy](const auto& numbers) {
    const BoundaryWork work = BoundaryWork::of(numbers);
    energy.static_ += work.held;
    energy.dashpots += work.dashpots;
    energy.springs += work.springs;
    energy.transfer += work.transfer;
    energy.input += work.input;
  });
}

Pass exchange_pass(Boundary& boundary, Support& support) {
  const auto run = [&](Step& step) {
    if (step.ticks.is_first())
      boundary.exchange(step, support);
  };
  if (support.is_timed())
    return {Phase::supports, support.name(), run};
  return {Phase::exchange, "", run};
}

} // namespace

std::vector<Pass> face_passes(Ground& ground, Boundary& boundary, FreeFieldSource free_field) {
  if (boundary.faces().empty())
    return {};
  if (!free_field)
    throw std::invalid_argument("a domain with boundary faces needs their free field");
  std::vector<Pass> passes;
  if (ground.share || ground.has_pore_pressure())
    passes.push_back({Phase::scatter, "", [&](Step&) { boundary.read_soil(ground); }});
  passes.push_back(
      {Phase::exchange, "boundary exchange", [&boundary, source = std::move(free_field)](Step& step) {
         if (step.ticks.is_first())
           boundary.exchange(step, source);
       }});
  for (const auto& support : boundary.supports().all())
    passes.push_back(exchange_pass(boundary, *support));
  if (!ground.spec.rigid_base)
    passes.push_back(
        {Phase::forces, "boundary tractions", [&boundary](Step& step) { boundary.apply(step); }});
  passes.push_back({Phase::books, "", [&boundary](Step& step) { book_faces(boundary, step); }});
  if (ground.is_remapped())
    passes.push_back({Phase::remap, "", [&boundary](Step& step) {
                        for (int clock = step.ticks.first_ending(); clock < step.ticks.clocks(); ++clock)
                          boundary.take_off_remap_power(step, clock);
                      }});
  for (const auto& support : boundary.supports().all())
    std::ranges::move(support->passes(ground), std::back_inserter(passes));
  return passes;
}

} // namespace tremolo::mpm_domain
