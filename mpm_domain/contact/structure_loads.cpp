#include "mpm_domain/contact/structure_loads.hpp"

#include "mpm_domain/contact/contact.hpp"
#include "mpm_domain/ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// act(node, force) for the nodes of the elastic bodies that carry a load.
template <class Act>
void over_loaded_nodes(const Contact& contact, const Ground& ground, const Act& act) {
  for (std::size_t b = 0; b < contact.bodies().size(); ++b) {
    const ElasticBody* const elastic = contact.elastic(b);
    const Vector a = contact.pull(b);
    if (elastic == nullptr || (a.x == 0.0 && a.y == 0.0))
      continue;
    const Lattice& own = ground.bodies[elastic->number()].lattice;
    for (std::size_t n = own.first; n < own.first + own.count(); ++n)
      act(n, Vector{ground.grid.mass[n] * a.x, ground.grid.mass[n] * a.y});
  }
}

/// Power of the loads on the mean of velocities before and after the last update, W/m.
double power_of_loads(const Contact& contact, const Ground& ground) {
  const Grid& grid = ground.grid;
  double power = 0.0;
  over_loaded_nodes(contact, ground, [&](std::size_t n, const Vector& force) {
    power += 0.5 * (force.x * (grid.vx_before[n] + grid.vx_after[n]) +
                    force.y * (grid.vy_before[n] + grid.vy_after[n]));
  });
  return power;
}

/// Leaves the loads out of the power that the remapped velocity makes.
void take_off_remap_power(const Contact& contact, Step& step) {
  const Grid& grid = step.ground.grid;
  over_loaded_nodes(contact, step.ground, [&](std::size_t n, const Vector& force) {
    step.remap_power[0][0].add(force.x * (grid.vx_strain[n] - grid.vx_after[n]) +
                               force.y * (grid.vy_strain[n] - grid.vy_after[n]));
  });
}

} // namespace

StructureLoads::StructureLoads(const Spec& spec) : on_(spec.structures.size()) {
  for (const StructureLoad& load : spec.structure_loads) {
    const auto found = std::ranges::find(spec.structures, load.structure, &Structure::name);
    if (found == spec.structures.end())
      throw std::invalid_argument(
          fmt::format("a load acts on the structure '{}', which is not there", load.structure));
    if (!std::isfinite(load.force.x) || !std::isfinite(load.force.y))
      throw std::invalid_argument(fmt::format("the load on structure '{}' is ({}, {}) N/m; allowed: finite",
                                              load.structure, load.force.x, load.force.y));
    loads_.push_back({static_cast<std::size_t>(found - spec.structures.begin()), load.force, load.growth,
                      load.growth ? 0.0 : 1.0});
  }
  add_up();
}

void StructureLoads::scale(std::size_t load, double share) {
  loads_[load].share = share;
  add_up();
}

void StructureLoads::grow(double time) {
  for (Load& load : loads_)
    if (load.growth)
      load.share = load.growth->share(time);
  add_up();
}

void StructureLoads::add_up() {
  std::ranges::fill(on_, Vector{});
  for (const Load& load : loads_) {
    Vector& sum = on_[load.structure];
    sum += load.share * load.force;
  }
}

void add_loads(const Contact& contact, Ground& ground) {
  over_loaded_nodes(contact, ground, [&](std::size_t n, const Vector& force) {
    ground.grid.force_x[n] += force.x;
    ground.grid.force_y[n] += force.y;
  });
}

std::vector<Pass> structure_load_passes(Ground& ground, Contact& contact) {
  const auto is_worked_on = [&](const StructureLoad& load) {
    if (load.growth)
      return true;
    const auto body = std::ranges::find(contact.bodies(), load.structure, &RigidBody::name);
    return contact.is_elastic(static_cast<std::size_t>(body - contact.bodies().begin()));
  };
  if (std::ranges::none_of(ground.spec.structure_loads, is_worked_on))
    return {};
  std::vector<Pass> passes{{Phase::forces, "loads on structures",
                            [&](Step& step) {
                              contact.structure_loads().grow(step.time);
                              add_loads(contact, ground);
                            }},
                           {Phase::books, "", [&](Step& step) {
                              const double work = step.kicks.front() * power_of_loads(contact, ground);
                              step.bookings.add(sums_of(std::array{work}),
                                                [&energy = step.energy](const std::array<double, 1>& booked) {
                                                  energy.static_ += booked[0];
                                                });
                            }}};
  if (ground.is_remapped())
    passes.push_back({Phase::remap, "", [&](Step& step) { take_off_remap_power(contact, step); }});
  return passes;
}

} // namespace tremolo::mpm_domain
