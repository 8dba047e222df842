#include "mpm_domain/step/node_passes.hpp"

#include "mpm_domain/step/grid_update.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

void find_velocities(Ground& ground, Step& step) {
  if (step.starts())
    step.energy.kinetic_start = 0.0;
  step.kinetic_off_grid = 0.0; // bodies and linings add theirs, in dry and in wet ground
  for (int clock = step.ticks.first_due(); clock < step.ticks.clocks(); ++clock)
    step.bookings.add(grid_velocities(ground, step.nodes.of(clock)),
                      [&gained = step.gained(), &last = step.kinetic[static_cast<std::size_t>(clock)]](
                          const auto& kinetic) { gained += kinetic[0] - last; });
}

void update_nodes(Ground& ground, Step& step) {
  for (int clock = step.ticks.first_due(); clock < step.ticks.clocks(); ++clock) {
    const auto of_clock = static_cast<std::size_t>(clock);
    step.kicks[of_clock] = step.ticks.kick_of(clock);
    step.bookings.add(update_grid(ground, step.kicks[of_clock], step.nodes.of(clock)),
                      [&energy = step.energy, &kinetic = step.kinetic[of_clock]](const auto& totals) {
                        const GridUpdate update(totals);
                        kinetic = update.kinetic;
                        energy.gravity += update.gravity_work;
                        energy.dashpots += update.dashpot_relief;
                      });
  }
}

void remap(Ground& ground, Step& step) {
  for (int clock = step.ticks.first_ending(); clock < step.ticks.clocks(); ++clock)
    step.remap_power[static_cast<std::size_t>(clock)] = remap_velocities(ground, step.nodes.of(clock));
}

/// @throws std::runtime_error if a velocity is not finite
void book_kinetic(Step& step) {
  step.bookings.add([&step] {
    step.energy.kinetic =
        std::accumulate(step.kinetic.begin(), step.kinetic.end(), 0.0) + step.kinetic_off_grid;
    if (!std::isfinite(step.energy.kinetic))
      throw std::runtime_error(
          fmt::format("a grid velocity is not finite at t = {:.6g} s, step {}", step.time, step.count));
  });
}

void book_remap(Step& step) {
  for (int clock = step.ticks.first_ending(); clock < step.ticks.clocks(); ++clock) {
    const auto of_clock = static_cast<std::size_t>(clock);
    step.book_transfer(0.5 * step.kicks[of_clock], step.remap_power[of_clock]);
  }
}

} // namespace

std::vector<Pass> node_passes(Ground& ground) {
  std::vector<Pass> passes{
      {Phase::velocities, "grid velocities", [&](Step& step) { find_velocities(ground, step); }}};
  if (!ground.has_flow())
    passes.push_back({Phase::update, "grid update", [&](Step& step) { update_nodes(ground, step); }});
  if (ground.is_remapped())
    passes.push_back({Phase::remap, "remapped velocities", [&](Step& step) { remap(ground, step); }});
  return passes;
}

std::vector<Pass> node_books(const Ground& ground) {
  std::vector<Pass> passes{{Phase::books, "", book_kinetic},
                           {Phase::books, "", [](Step& step) { step.shared.follow_update(); }}};
  if (ground.is_remapped())
    passes.push_back({Phase::remap, "", book_remap});
  return passes;
}

} // namespace tremolo::mpm_domain
