#include "mpm_domain/water/water_scatter.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/add_sums.hpp"
#include "mpm_domain/transfer/scatter_kernel.hpp"
#include "mpm_domain/water/storage.hpp"

#include <array>

namespace tremolo::mpm_domain {

namespace {

/// The numbers of a group of particles under water that add up to lift and storage; where water flows in the
/// domain, to volume and resistance too.
template <std::size_t count, typename Group>
std::array<Lanes, count> pore_numbers(const Particles& p, double gravity, std::size_t k, Group group) {
  std::array<Lanes, count> numbers{};
  numbers[0] = (1.0 - p.weight_share) * gravity * group.load(&p.mass[k]);
  if (p.traits.wet)
    numbers[1] = storage_of(p, k, group);
  if constexpr (count == 4)
    if (p.traits.flowing) {
      numbers[2] = group.load(&p.volume[k]);
      numbers[3] = p.water->resistance() * numbers[2];
    }
  return numbers;
}

template <std::size_t count>
void add_pores(Domain& domain) {
  constexpr SumRange fields{static_cast<std::size_t>(Sum::lift), static_cast<std::size_t>(Sum::lift) + count};
  const double gravity = domain.spec.gravity;
  add_sums(
      domain, 0, fields,
      [&](const Particles& p, std::size_t tile, double* window) {
        if (!p.water)
          return RowRange{};
        return scatter_scalars<count>(domain, p, 0, tile, window, Sum::lift, [&](std::size_t k, auto group) {
          return pore_numbers<count>(p, gravity, k, group);
        });
      },
      [&](AcrossTile& tile) {
        const Particles& p = domain.sets[tile.set];
        add_across_tile(tile, fields, [&](std::size_t k, const FourWeights& w, const auto& add) {
          if (!p.water)
            return;
          const std::array<Lanes, count> numbers = pore_numbers<count>(p, gravity, k, FewerThanFour(1));
          for (std::size_t f = 0; f < count; ++f)
            add(fields.first + f, numbers[f][0] * w.s);
        });
      });
}

template <Motion motion, bool force>
void add_water(Domain& domain) {
  constexpr SumRange fields = fields_of<WaterPhase>(motion, force);
  add_sums(
      domain, 0, fields,
      [&](const Particles& p, std::size_t tile, double* window) {
        return p.traits.flowing ? scatter_set<WaterPhase, motion, force>(domain, p, 0, tile, window)
                                : RowRange{};
      },
      [&](AcrossTile& tile) {
        if (domain.sets[tile.set].traits.flowing)
          scatter_across_set<WaterPhase, motion, force>(domain, tile);
        else
          add_across_tile(tile, fields, [](auto, const auto&, const auto&) {});
      });
}

} // namespace

void scatter_water(Domain& domain, std::span<const NodeRange> nodes, std::span<const std::size_t> ties) {
  clear(domain, NodeGroup::pores, nodes);
  if (domain.has_flow())
    for (const NodeGroup group : {NodeGroup::water_mass, NodeGroup::water_momentum, NodeGroup::water_force})
      clear(domain, group, nodes);
  domain.has_flow() ? add_pores<4>(domain) : add_pores<2>(domain);
  fold(domain, NodeGroup::pores, ties);
  if (!domain.has_flow())
    return;
  add_water<Motion::mass_and_momentum, true>(domain);
  for (const NodeGroup group : {NodeGroup::water_mass, NodeGroup::water_momentum, NodeGroup::water_force})
    fold(domain, group, ties);
}

void scatter_water_momenta(Domain& domain, std::span<const NodeRange> nodes,
                           std::span<const std::size_t> ties) {
  clear(domain, NodeGroup::water_momentum, nodes);
  add_water<Motion::momentum, false>(domain);
  fold(domain, NodeGroup::water_momentum, ties);
}

} // namespace tremolo::mpm_domain
