#include "mpm_domain/earthworks/held_forces.hpp"

#include "mpm_domain/ranks/lists_of_all.hpp"
#include "mpm_domain/transfer/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace tremolo::mpm_domain {

namespace {

/// Number of the node of a lattice at the left or the lower edge of the model.
int first_in_model(double edge, double origin, double h) {
  return static_cast<int>(std::lround((edge - origin) / h));
}

/// Gives what ranks have of nodes to one rank for each column of nodes, whoever has them.
std::map<PositionInModel, NodeLoad> by_columns(const std::map<PositionInModel, NodeLoad>& own,
                                               Communicator& ranks) {
  std::vector<std::vector<double>> lists(static_cast<std::size_t>(ranks.size()));
  for (const auto& [position, load] : own) {
    const auto& [level, column, row] = position;
    std::vector<double>& list = lists[static_cast<std::size_t>(std::abs(column) % ranks.size())];
    list.insert(list.end(), {static_cast<double>(level), static_cast<double>(column),
                             static_cast<double>(row), load.mass, load.force.x, load.force.y});
  }
  std::map<PositionInModel, NodeLoad> loads;
  for (const std::vector<double>& numbers : ranks.swap(lists))
    for (std::size_t n = 0; n < numbers.size(); n += 6)
      loads[{static_cast<int>(numbers[n]), static_cast<int>(numbers[n + 1]),
             static_cast<int>(numbers[n + 2])}] = {numbers[n + 3], {numbers[n + 4], numbers[n + 5]}};
  return loads;
}

/// Finds c.
std::map<PositionInModel, Vector> lacking_forces(const std::map<PositionInModel, NodeLoad>& before,
                                                 const std::map<PositionInModel, NodeLoad>& after) {
  std::map<PositionInModel, Vector> forces;
  for (const auto& [position, now] : after) {
    const auto found = before.find(position);
    const NodeLoad had = found == before.end() ? NodeLoad{now.mass, {}} : found->second;
    const double share = std::min(1.0, now.mass / had.mass);
    const Vector lacking = share * had.force - now.force;
    if (lacking.x != 0.0 || lacking.y != 0.0)
      forces[position] = lacking;
  }
  return forces;
}

} // namespace

std::map<PositionInModel, NodeLoad> node_loads(Ground& ground) {
  scatter(ground, ScatterPart::both);
  const Grid& grid = ground.grid;
  std::map<PositionInModel, NodeLoad> loads;
  for (int level = 0; level < ground.soil_lattice_count(); ++level) {
    const Lattice& lattice = ground.lattice(level);
    const int left = first_in_model(ground.spec.box.x_min, lattice.x0, lattice.h);
    const int low = first_in_model(ground.spec.box.y_min, lattice.y0, lattice.h);
    for (int j = 0; j < lattice.ny; ++j)
      for (int i = 0; i < lattice.nx; ++i)
        if (const std::size_t n = lattice.index(i, j); grid.mass[n] > 0.0 && ground.counts({n, n + 1}))
          loads[{level, i - left, j - low}] = {grid.mass[n], {grid.force_x[n], grid.force_y[n]}};
  }
  return loads;
}

HeldForces::HeldForces(const std::map<PositionInModel, NodeLoad>& before,
                       const std::map<PositionInModel, NodeLoad>& after, Communicator* ranks) {
  if (ranks == nullptr) {
    forces_ = lacking_forces(before, after);
    return;
  }
  forces_ = lacking_forces(by_columns(before, *ranks), by_columns(after, *ranks));
  set_state(lists_of_all(*ranks, state()));
}

template <class Act>
void HeldForces::over_nodes(const Ground& ground, double share, const Act& act) const {
  for (const auto& [position, force] : forces_) {
    const auto& [level, i, j] = position;
    const Lattice& lattice = ground.lattice(level);
    act(lattice.index(i + first_in_model(ground.spec.box.x_min, lattice.x0, lattice.h),
                      j + first_in_model(ground.spec.box.y_min, lattice.y0, lattice.h)),
        share * force);
  }
}

void HeldForces::act(Ground& ground, double share) const {
  over_nodes(ground, share, [&](std::size_t n, const Vector& force) {
    ground.grid.force_x[n] += force.x;
    ground.grid.force_y[n] += force.y;
  });
}

/// @param power_on  (node, force) of a node, W/m
template <class PowerOn>
ExactSums<1> HeldForces::sum_over_nodes(const Ground& ground, double share, const PowerOn& power_on) const {
  ExactSums<1> power;
  over_nodes(ground, share, [&](std::size_t n, const Vector& force) {
    if (ground.counts({n, n + 1}))
      power[0].add(power_on(n, force));
  });
  return power;
}

ExactSums<1> HeldForces::power(const Ground& ground, double share) const {
  return sum_over_nodes(ground, share, [&grid = ground.grid](std::size_t n, const Vector& force) {
    return 0.5 * (force.x * (grid.vx_before[n] + grid.vx_after[n]) +
                  force.y * (grid.vy_before[n] + grid.vy_after[n]));
  });
}

ExactSums<1> HeldForces::remap_power(const Ground& ground, double share) const {
  return sum_over_nodes(ground, share, [&grid = ground.grid](std::size_t n, const Vector& force) {
    return force.x * (grid.vx_strain[n] - grid.vx_after[n]) +
           force.y * (grid.vy_strain[n] - grid.vy_after[n]);
  });
}

std::vector<double> HeldForces::state() const {
  std::vector<double> numbers;
  for (const auto& [position, force] : forces_)
    numbers.insert(numbers.end(), {static_cast<double>(position[0]), static_cast<double>(position[1]),
                                   static_cast<double>(position[2]), force.x, force.y});
  return numbers;
}

void HeldForces::set_state(const std::vector<double>& state) {
  forces_.clear();
  for (std::size_t n = 0; n + 4 < state.size(); n += 5)
    forces_[{static_cast<int>(state[n]), static_cast<int>(state[n + 1]), static_cast<int>(state[n + 2])}] = {
        state[n + 3], state[n + 4]};
}

} // namespace tremolo::mpm_domain
