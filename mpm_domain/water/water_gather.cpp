#include "mpm_domain/water/water_gather.hpp"

#include "mpm_domain/transfer/for_samples.hpp"

namespace tremolo::mpm_domain {

namespace {

template <bool affine>
constexpr Wanted wanted_of{.v_before = !affine, .v_after = true, .affine = affine};

template <bool affine, typename Group>
void take(Particles& p, std::size_t k, Group group, const Samples& q) {
  if constexpr (affine) {
    group.store(&p.wx[k], q.v_after.x);
    group.store(&p.wy[k], q.v_after.y);
    group.store(&p.wbxx[k], q.bxx);
    group.store(&p.wbxy[k], q.bxy);
    group.store(&p.wbyx[k], q.byx);
    group.store(&p.wbyy[k], q.byy);
  } else {
    group.store(&p.wx[k], group.load(&p.wx[k]) + q.v_after.x - q.v_before.x);
    group.store(&p.wy[k], group.load(&p.wy[k]) + q.v_after.y - q.v_before.y);
  }
}

template <bool affine>
void gather_as(Domain& domain) {
  const VelocityFields velocities = of_water(domain.grid);
  for_tiles(
      domain, 0,
      [&](Particles& p, const ParticleRange& range, std::size_t tile) {
        if (p.traits.flowing)
          for_samples<wanted_of<affine>>(
              domain, p, range, tile, velocities,
              [&](std::size_t k, auto group, const Samples& q) { take<affine>(p, k, group, q); });
      },
      [&](Particles& p, const AcrossTile& tile) {
        if (p.traits.flowing)
          for_samples<wanted_of<affine>>(
              domain, p, tile, velocities,
              [&](std::size_t k, auto group, const Samples& q) { take<affine>(p, k, group, q); });
      });
}

} // namespace

void gather_water(Domain& domain) {
  domain.spec.scheme.transfer == Transfer::apic ? gather_as<true>(domain) : gather_as<false>(domain);
}

} // namespace tremolo::mpm_domain
