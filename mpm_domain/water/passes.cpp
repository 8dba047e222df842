#include "mpm_domain/water/passes.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/water/mixture_update.hpp"
#include "mpm_domain/water/pore_pressure.hpp"
#include "mpm_domain/water/seepage_force.hpp"
#include "mpm_domain/water/water_gather.hpp"
#include "mpm_domain/water/water_scatter.hpp"

namespace tremolo::mpm_domain {

namespace {

void find_water_velocities(Ground& ground, Step& step) {
  step.bookings.add(water_velocities(ground, step.nodes.of(0)),
                    [&gained = step.gained()](const auto& kinetic) { gained += kinetic[0]; });
}

void update_both(Ground& ground, Step& step) {
  step.kicks.front() = step.ticks.kick_of(0);
  step.bookings.add(update_mixture(ground, step.kicks.front(), step.nodes.of(0)),
                    [&step](const auto& totals) {
                      const MixtureUpdate update(totals);
                      step.kinetic.front() = update.kinetic;
                      step.energy.gravity += update.gravity_work;
                      step.energy.dashpots += update.dashpot_relief;
                      step.energy.drag += update.drag;
                    });
}

void exchange_velocities(Ground& ground, Step& step) {
  prolong(ground, NodeGroup::velocity, step.nodes.ties_of(0));
  prolong(ground, NodeGroup::water_velocity, step.nodes.ties_of(0));
  exchange_mixture_velocities(ground, step.nodes.of(0), step.nodes.ties_of(0));
}

void remap_water(Ground& ground, Step& step) {
  step.book_transfer(0.5 * step.kicks.front(), remap_flux(ground, step.nodes.of(0)));
}

void find_pressures(Ground& ground, Step& step, const NodeField& flux_x, const NodeField& flux_y) {
  step.bookings.add(
      update_pressures(ground, step.ticks.dt_of(0), flux_x, flux_y, step.nodes.of(0), step.nodes.ties_of(0)),
      [&energy = step.energy](const auto& work) { energy.pore += work[0]; });
}

void find_pressures_of_flow(Ground& ground, Step& step) {
  if (!ground.is_remapped())
    find_flux(ground, step.nodes.of(0));
  prolong(ground, NodeGroup::volume_flux, step.nodes.ties_of(0));
  find_pressures(ground, step, ground.grid.flux_x, ground.grid.flux_y);
}

void find_pressures_of_grains(Ground& ground, Step& step) {
  const Grid& grid = ground.grid;
  prolong(ground, NodeGroup::velocity, step.nodes.ties_of(0));
  if (ground.is_remapped())
    find_pressures(ground, step, grid.vx_strain, grid.vy_strain);
  else
    find_pressures(ground, step, grid.vx_after, grid.vy_after);
}

/// The update and the remap have booked all of the weight, and nothing of the seepage force.
void book_lift(Ground& ground, Step& step) {
  step.bookings.add(buoyancy_power(ground, step.nodes.of(0)),
                    [&energy = step.energy, kick = step.kicks.front()](const auto& power) {
                      energy.gravity += kick * power[0];
                    });
  if (ground.is_remapped())
    step.book_transfer(-0.5 * step.kicks.front(), buoyancy_remap_power(ground, step.nodes.of(0)));
}

void pull_by_seepage(Ground& ground, Step& step) {
  scatter_seepage(ground, step.nodes.of(0), step.nodes.ties_of(0));
  add_seepage(ground, step.nodes.of(0));
}

/// Water leaves the grid before the particles move.
void gather_all_water(Ground& ground, Step& step) {
  prolong(ground, NodeGroup::water_velocity, step.nodes.ties_of(0));
  gather_water(ground);
}

} // namespace

std::vector<Pass> wet_transfer_passes(Ground& ground) {
  std::vector<Pass> passes;
  if (ground.has_seepage())
    passes.push_back({Phase::scatter, "head at particles", [&](Step&) { follow_head(ground); }});
  if (ground.has_water())
    passes.push_back({Phase::scatter, "particles to grid",
                      [&](Step& step) { scatter_mixture(ground, step.nodes.of(0), step.nodes.ties_of(0)); }});
  if (ground.has_seepage())
    passes.push_back({Phase::scatter, "seepage force", [&](Step& step) { pull_by_seepage(ground, step); }});
  if (ground.has_flow() && ground.is_remapped())
    passes.push_back({Phase::gather, "grid to particles and back",
                      [&](Step& step) { exchange_velocities(ground, step); }});
  return passes;
}

std::vector<Pass> water_passes(Ground& ground) {
  if (!ground.has_water())
    return {};
  std::vector<Pass> passes;
  const auto add = [&](Phase phase, const char* name, void (*run)(Ground&, Step&)) {
    passes.push_back({phase, name, [&ground, run](Step& step) { run(ground, step); }});
  };
  const bool flows = ground.has_flow();
  if (flows) {
    add(Phase::velocities, "", find_water_velocities);
    add(Phase::update, "grid update", update_both);
  }
  if (flows && ground.is_remapped())
    add(Phase::remap, "", remap_water);
  if (ground.has_pore_pressure())
    add(Phase::pressure, "pore pressure", flows ? find_pressures_of_flow : find_pressures_of_grains);
  add(Phase::pressure, "weight under water", book_lift);
  if (flows && !ground.is_remapped())
    add(Phase::pressure, "", gather_all_water);
  return passes;
}

} // namespace tremolo::mpm_domain
