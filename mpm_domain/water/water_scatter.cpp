#include "mpm_domain/water/water_scatter.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/add_sums.hpp"
#include "mpm_domain/transfer/scatter_kernel.hpp"

#include <array>

namespace tremolo::mpm_domain {

namespace {

constexpr std::array water_sums{NodeGroup::water_mass, NodeGroup::water_momentum, NodeGroup::water_force};

/// Soil without pores, or whose water does not flow, lets none enter: a resistance beyond all drag of soil
/// takes the relative velocity of the nodes that it touches. Above the table soil without pores is open.
constexpr double sealed = 1e30; // Pa s/m2

bool is_sealed(const Domain& domain, const Particles& p) {
  return !p.body && !p.traits.flowing && (p.traits.wet || !domain.spec.soils[p.soil_index].pores);
}

template <typename Group>
Lanes seal(const Particles& p, const Spec& spec, std::size_t k, Group group) {
  const Lanes resistance = sealed * group.load(&p.volume[k]);
  return p.traits.wet ? resistance
                      : choose(group.load(&p.y_initial[k]) < spec.water->level, resistance, Lanes{});
}

RowRange seal_tile(const Domain& domain, const Particles& p, std::size_t tile, double* window) {
  return scatter_scalars<1>(domain, p, 0, tile, window, Sum::resistance, [&](std::size_t k, auto group) {
    return std::array{seal(p, domain.spec, k, group)};
  });
}

/// @param fields  of the pass; without resistance it adds nothing
void seal_across(const Domain& domain, AcrossTile& tile, SumRange fields) {
  const Particles& p = domain.sets[tile.set];
  const bool seals = fields.end > static_cast<std::size_t>(Sum::resistance) && is_sealed(domain, p);
  add_across_tile(tile, fields, [&](std::size_t k, const FourWeights& w, const auto& add) {
    if (seals)
      add(static_cast<std::size_t>(Sum::resistance), seal(p, domain.spec, k, FewerThanFour(1))[0] * w.s);
  });
}

template <Motion motion, bool force>
void add_water(Domain& domain) {
  constexpr SumRange fields = fields_of<WaterPhase>(motion, force);
  add_sums(
      domain, 0, fields,
      [&](const Particles& p, std::size_t tile, double* window) {
        if (p.traits.flowing)
          return scatter_set<WaterPhase, motion, force>(domain, p, 0, tile, window);
        return force && is_sealed(domain, p) ? seal_tile(domain, p, tile, window) : RowRange{};
      },
      [&](AcrossTile& tile) {
        if (domain.sets[tile.set].traits.flowing)
          scatter_across_set<WaterPhase, motion, force>(domain, tile);
        else
          seal_across(domain, tile, fields);
      });
}

} // namespace

void scatter_water(Domain& domain, std::span<const NodeRange> nodes, std::span<const std::size_t> ties) {
  for (const NodeGroup group : water_sums)
    clear(domain, group, nodes);
  add_water<Motion::mass_and_momentum, true>(domain);
  for (const NodeGroup group : water_sums)
    fold(domain, group, ties);
}

void scatter_water_momenta(Domain& domain, std::span<const NodeRange> nodes,
                           std::span<const std::size_t> ties) {
  clear(domain, NodeGroup::water_momentum, nodes);
  add_water<Motion::momentum, false>(domain);
  fold(domain, NodeGroup::water_momentum, ties);
}

void scatter_lift(Domain& domain, std::span<const NodeRange> nodes, std::span<const std::size_t> ties) {
  constexpr SumRange fields = sums_between(Sum::lift, Sum::lift);
  const auto lift_of = [&](const Particles& p) { return (1.0 - p.weight_share) * domain.spec.gravity; };
  clear(domain, NodeGroup::pores, nodes);
  add_sums(
      domain, 0, fields,
      [&](const Particles& p, std::size_t tile, double* window) {
        if (!p.water)
          return RowRange{};
        return scatter_scalars<1>(domain, p, 0, tile, window, Sum::lift, [&](std::size_t k, auto group) {
          return std::array{lift_of(p) * group.load(&p.mass[k])};
        });
      },
      [&](AcrossTile& tile) {
        const Particles& p = domain.sets[tile.set];
        add_across_tile(tile, fields, [&](std::size_t k, const FourWeights& w, const auto& add) {
          add(fields.first, lift_of(p) * p.mass[k] * w.s);
        });
      });
  fold(domain, NodeGroup::pores, ties);
}

} // namespace tremolo::mpm_domain
