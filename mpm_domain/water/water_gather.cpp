#include "mpm_domain/water/water_gather.hpp"

#include "mpm_domain/transfer/for_samples.hpp"

namespace tremolo::mpm_domain {

namespace {

template <bool affine>
constexpr Wanted wanted{.v_before = !affine, .v_after = true, .affine = affine};

/// The columns of the particles' motion.
struct MotionColumns {
  std::vector<double>&x, &y, &bxx, &bxy, &byx, &byy;
};
MotionColumns motion_of_soil(Particles& p) {
  return {p.vx, p.vy, p.bxx, p.bxy, p.byx, p.byy};
}
MotionColumns motion_of_water(Particles& p) {
  return {p.wx, p.wy, p.wbxx, p.wbxy, p.wbyx, p.wbyy};
}

template <bool affine, typename Group>
[[gnu::always_inline]] inline void take(const MotionColumns& to, std::size_t k, Group group,
                                        const Samples& q) {
  if constexpr (affine) {
    group.store(&to.x[k], q.v_after.x);
    group.store(&to.y[k], q.v_after.y);
    group.store(&to.bxx[k], q.bxx);
    group.store(&to.bxy[k], q.bxy);
    group.store(&to.byx[k], q.byx);
    group.store(&to.byy[k], q.byy);
  } else {
    group.store(&to.x[k], group.load(&to.x[k]) + q.v_after.x - q.v_before.x);
    group.store(&to.y[k], group.load(&to.y[k]) + q.v_after.y - q.v_before.y);
  }
}

template <bool affine>
void gather_tile(Domain& domain, Particles& p, std::size_t tile, bool soil) {
  const VelocityFields of_grains = of_soil(domain.grid);
  const VelocityFields of_pores = of_water(domain.grid);
  for_readers(
      domain, p, p.in_block(domain.block(0, tile)),
      tile, [&](std::size_t k, auto group, const auto& reader) __attribute__((always_inline)) {
        if (soil)
          take<affine>(motion_of_soil(p), k, group, samples_at<wanted<affine>>(reader, of_grains));
        if (p.traits.flowing)
          take<affine>(motion_of_water(p), k, group, samples_at<wanted<affine>>(reader, of_pores));
      });
}

template <bool affine>
void gather_across(Domain& domain, const AcrossTile& tile, bool soil) {
  Particles& p = domain.sets[tile.set];
  by_fours(tile.weights.first(), tile.weights.end(), [&](std::size_t k, auto group) {
    const auto sample = [&](const VelocityFields& v) {
      return sample_across<wanted<affine>>(v, tile.weights, domain.basis_cells, p, k, group.count);
    };
    if (soil)
      take<affine>(motion_of_soil(p), k, group, sample(of_soil(domain.grid)));
    if (p.traits.flowing)
      take<affine>(motion_of_water(p), k, group, sample(of_water(domain.grid)));
  });
}

bool is_affine(const Domain& domain) {
  return domain.spec.scheme.transfer == Transfer::apic;
}

void gather(Domain& domain, Particles& p, std::size_t tile, bool soil) {
  is_affine(domain) ? gather_tile<true>(domain, p, tile, soil) : gather_tile<false>(domain, p, tile, soil);
}

void gather(Domain& domain, const AcrossTile& tile, bool soil) {
  is_affine(domain) ? gather_across<true>(domain, tile, soil) : gather_across<false>(domain, tile, soil);
}

} // namespace

void gather_water(Domain& domain) {
  for_tiles(
      domain, 0,
      [&](Particles& p, const ParticleRange&, std::size_t tile) {
        if (p.traits.flowing)
          gather(domain, p, tile, false);
      },
      [&](Particles&, const AcrossTile& tile) { gather(domain, tile, false); });
}

void gather_mixture(Domain& domain, Particles& p, std::size_t tile) {
  gather(domain, p, tile, true);
}

void gather_mixture(Domain& domain, const AcrossTile& tile) {
  gather(domain, tile, true);
}

} // namespace tremolo::mpm_domain
