#include "mpm_domain/water/water_scatter.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/add_sums.hpp"
#include "mpm_domain/transfer/scatter_kernel.hpp"
#include "mpm_domain/water/pore_pressure.hpp"
#include "mpm_domain/water/water_gather.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// The sums of all submerged soil.
constexpr SumRange numbers = sums_between(Sum::buoyancy, Sum::pore_volume);

/// Soil without pores, or whose water does not flow, lets none enter. Above the table soil without pores is
/// open.
bool is_sealed(const Ground& ground, const Particles& p) {
  return !p.body && !p.traits.flowing && (p.traits.wet || !ground.spec.soils[p.soil_index].pores);
}

template <typename Group>
Lanes seal(const Particles& p, const Head& head, std::size_t k, Group group) {
  Lanes resistance = sealed * group.load(&p.volume[k]);
  if (!p.traits.wet)
    for (std::size_t lane = 0; lane < group.count; ++lane)
      if (!head.is_wet(p.x_initial[k + lane], p.y_initial[k + lane]))
        resistance[lane] = 0.0;
  return resistance;
}

RowRange seal_tile(const Ground& ground, const Particles& p, std::size_t tile, double* window) {
  return scatter_scalars<1>(ground, p, 0, tile, window, Sum::resistance, [&](std::size_t k, auto group) {
    return std::array{seal(p, *ground.head, k, group)};
  });
}

/// @param fields  of the pass; without resistance it adds nothing
void seal_across(const Ground& ground, AcrossTile& tile, SumRange fields) {
  const Particles& p = ground.sets[tile.set];
  const bool seals = fields.end > static_cast<std::size_t>(Sum::resistance) && is_sealed(ground, p);
  add_across_tile(tile, fields, [&](std::size_t k, const FourWeights& w, const auto& add) {
    if (seals)
      add(static_cast<std::size_t>(Sum::resistance), seal(p, *ground.head, k, FewerThanFour(1))[0] * w.s);
  });
}

/// Adds up what soil and its water bring, which with momenta alone take their velocities from the grid
/// before.
template <Motion motion, bool force>
void add_mixture(Ground& ground, std::span<const SumRange> fields) {
  constexpr bool takes_velocities = motion == Motion::momentum;
  add_sums(
      ground, 0, fields,
      [&](Particles& p, std::size_t tile, double* window) {
        if constexpr (takes_velocities)
          gather_mixture(ground, p, tile);
        CellRuns* const runs = takes_pressure(p) ? &waiting_of(ground, p).runs[tile] : nullptr;
        if (p.traits.flowing)
          return scatter_set<PoreWaterCoupling::flow, motion, force>(ground, p, 0, tile, window, runs);
        RowRange rows =
            p.water ? scatter_set<PoreWaterCoupling::numbers, motion, force>(ground, p, 0, tile, window, runs)
                    : scatter_set<PoreWaterCoupling::none, motion, force>(ground, p, 0, tile, window);
        if (force && ground.has_flow() && is_sealed(ground, p))
          rows.add(seal_tile(ground, p, tile, window));
        return rows;
      },
      [&](AcrossTile& tile) {
        if constexpr (takes_velocities)
          gather_mixture(ground, tile);
        const Particles& p = ground.sets[tile.set];
        scatter_across_set<SoilPhase, motion, force>(ground, tile);
        if (p.traits.flowing)
          scatter_across_set<WaterPhase, motion, force>(ground, tile);
        else if (ground.has_flow())
          seal_across(ground, tile, fields_of<WaterPhase>(motion, force));
        if (force)
          add_across_tile(tile, numbers, [&](std::size_t k, const FourWeights& w, const auto& add) {
            if (!p.water)
              return;
            const auto [buoyancy, pores] = numbers_of_water(p, k, FewerThanFour(1), ground.spec.gravity);
            add(static_cast<std::size_t>(Sum::buoyancy), buoyancy[0] * w.s);
            add(static_cast<std::size_t>(Sum::pore_volume), pores[0] * w.s);
          });
      });
}

void clear_groups(Ground& ground, std::span<const NodeGroup> groups, std::span<const NodeRange> nodes) {
  std::vector<NodeField*> fields;
  for (const NodeGroup group : groups)
    for_group(ground.grid, group, [&](NodeField& field) { fields.push_back(&field); });
  ground.workers.run(nodes.size(), [&](std::size_t row) {
    for (NodeField* field : fields)
      std::fill(field->data() + nodes[row].begin, field->data() + nodes[row].end, 0.0);
  });
}

constexpr std::array of_mixture{NodeGroup::mass,       NodeGroup::momentum,   NodeGroup::force,
                                NodeGroup::pores,      NodeGroup::water_mass, NodeGroup::water_momentum,
                                NodeGroup::water_force};
constexpr std::size_t without_flow = 4; // of them
constexpr std::array momenta{NodeGroup::momentum, NodeGroup::water_momentum};

} // namespace

void scatter_mixture(Ground& ground, std::span<const NodeRange> nodes, std::span<const std::size_t> ties) {
  const std::span groups = std::span(of_mixture).first(ground.has_flow() ? of_mixture.size() : without_flow);
  clear_groups(ground, groups, nodes);
  for (WaitingPressures& waiting : ground.waiting_pressures)
    waiting.runs.resize(ground.tiles.count());
  add_mixture<Motion::mass_and_momentum, true>(ground, scattered_sums(ground.grid.traits));
  for (const NodeGroup group : groups)
    fold(ground, group, ties);
}

void exchange_mixture_velocities(Ground& ground, std::span<const NodeRange> nodes,
                                 std::span<const std::size_t> ties) {
  clear_groups(ground, momenta, nodes);
  add_mixture<Motion::momentum, false>(
      ground, std::array{sums_between(Sum::momentum_x, Sum::momentum_y),
                         sums_between(Sum::water_momentum_x, Sum::water_momentum_y)});
  for (const NodeGroup group : momenta)
    fold(ground, group, ties);
}

} // namespace tremolo::mpm_domain
