#include "mpm_domain/boundary/passes/passes.hpp"
#include "mpm_domain/ground.hpp"

#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

void book_faces(Ground& ground, Boundary& boundary, Step& step) {
  const BoundaryWork work = boundary.follow_update(ground, step.ticks, step.nodes);
  step.bookings.add([&energy = step.energy, work] {
    energy.static_ += work.held;
    energy.dashpots += work.dashpots;
    energy.springs += work.springs;
    energy.transfer += work.transfer;
    energy.input += work.input;
  });
}

void take_off_remap_power(Ground& ground, const Boundary& boundary, Step& step) {
  for (int clock = step.ticks.first_ending(); clock < step.ticks.clocks(); ++clock)
    boundary.take_off_remap_power(ground, step.nodes, clock,
                                  step.remap_power[static_cast<std::size_t>(clock)][0]);
}

} // namespace

std::vector<Pass> face_passes(Ground& ground, Boundary& boundary, FreeFieldSource free_field) {
  if (boundary.faces().empty())
    return {};
  if (!free_field)
    throw std::invalid_argument("a domain with boundary faces needs to be told their free field");
  std::vector<Pass> passes;
  if (ground.share || ground.has_pore_pressure())
    passes.push_back({Phase::scatter, "", [&](Step&) { boundary.read_soil(ground); }});
  passes.push_back({Phase::exchange, "boundary exchange", [&, source = std::move(free_field)](Step& step) {
                      if (step.ticks.is_first())
                        boundary.exchange(ground, step.nodes, source, step.count, step.time);
                    }});
  if (boundary.has_layers())
    passes.push_back({Phase::supports, "matched layers", [&](Step& step) {
                        if (step.ticks.is_first())
                          boundary.react(step.time, ground.workers);
                      }});
  if (!boundary.rigid_base())
    passes.push_back({Phase::forces, "boundary tractions",
                      [&](Step& step) { boundary.apply(ground, step.ticks, step.nodes); }});
  passes.push_back({Phase::books, "", [&](Step& step) { book_faces(ground, boundary, step); }});
  if (ground.is_remapped())
    passes.push_back({Phase::remap, "", [&](Step& step) { take_off_remap_power(ground, boundary, step); }});
  return passes;
}

} // namespace tremolo::mpm_domain
