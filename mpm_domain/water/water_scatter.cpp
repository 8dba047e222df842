#include "mpm_domain/water/water_scatter.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/add_sums.hpp"
#include "mpm_domain/transfer/scatter_kernel.hpp"
#include "mpm_domain/water/storage.hpp"

#include <array>

namespace tremolo::mpm_domain {

namespace {

/// Soil without pores, or whose water does not flow, lets none enter: a resistance beyond all drag of soil
/// takes the relative velocity of the nodes that it touches. Above the table it is dry and open.
constexpr double sealed = 1e30; // Pa s/m2

/// The numbers of a group of particles that add up to lift and storage; where water flows in the domain, to
/// volume and resistance too.
template <std::size_t count, typename Group>
std::array<Lanes, count> pore_numbers(const Particles& p, const Spec& spec, std::size_t k, Group group) {
  std::array<Lanes, count> numbers{};
  numbers[0] = (1.0 - p.weight_share) * spec.gravity * group.load(&p.mass[k]);
  if (p.traits.wet)
    numbers[1] = storage_of(p, k, group);
  if constexpr (count == 4) {
    const Lanes volume = group.load(&p.volume[k]);
    if (p.traits.flowing) {
      numbers[2] = volume;
      numbers[3] = p.water->resistance() * volume;
    } else if (p.traits.wet) {
      numbers[3] = sealed * volume;
    } else if (!p.water) {
      numbers[3] = choose(group.load(&p.y_initial[k]) < spec.water->level, sealed * volume, Lanes{});
    }
  }
  return numbers;
}

/// Whether any numbers of a set are to be added up.
bool takes_part(const Domain& domain, const Particles& p) {
  return p.water || (domain.has_flow() && !domain.spec.soils[p.soil_index].pores);
}

template <std::size_t count>
void add_pores(Domain& domain) {
  constexpr SumRange fields{static_cast<std::size_t>(Sum::lift), static_cast<std::size_t>(Sum::lift) + count};
  add_sums(
      domain, 0, fields,
      [&](const Particles& p, std::size_t tile, double* window) {
        if (!takes_part(domain, p))
          return RowRange{};
        return scatter_scalars<count>(domain, p, 0, tile, window, Sum::lift, [&](std::size_t k, auto group) {
          return pore_numbers<count>(p, domain.spec, k, group);
        });
      },
      [&](AcrossTile& tile) {
        const Particles& p = domain.sets[tile.set];
        add_across_tile(tile, fields, [&](std::size_t k, const FourWeights& w, const auto& add) {
          if (!takes_part(domain, p))
            return;
          const std::array<Lanes, count> numbers = pore_numbers<count>(p, domain.spec, k, FewerThanFour(1));
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
