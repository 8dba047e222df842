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
void gather_tile(Ground& ground, Particles& p, std::size_t tile, bool soil) {
  const VelocityFields of_grains = of_soil(ground.grid);
  const VelocityFields of_pores = of_water(ground.grid);
  for_readers(
      ground, p, p.in_block(ground.block(0, tile)),
      tile, [&](std::size_t k, auto group, const auto& reader) __attribute__((always_inline)) {
        if (soil)
          take<affine>(motion_of_soil(p), k, group, samples_at<wanted<affine>>(reader, of_grains));
        if (p.traits.flowing)
          take<affine>(motion_of_water(p), k, group, samples_at<wanted<affine>>(reader, of_pores));
      });
}

template <bool affine>
void gather_across(Ground& ground, const AcrossTile& tile, bool soil) {
  Particles& p = ground.sets[tile.set];
  by_fours(tile.weights.first(), tile.weights.end(), [&](std::size_t k, auto group) {
    const auto sample = [&](const VelocityFields& v) {
      return sample_across<wanted<affine>>(v, tile.weights, ground.basis_cells, p, k, group.count);
    };
    if (soil)
      take<affine>(motion_of_soil(p), k, group, sample(of_soil(ground.grid)));
    if (p.traits.flowing)
      take<affine>(motion_of_water(p), k, group, sample(of_water(ground.grid)));
  });
}

bool is_affine(const Ground& ground) {
  return ground.spec.scheme.transfer == Transfer::apic;
}

void gather(Ground& ground, Particles& p, std::size_t tile, bool soil) {
  is_affine(ground) ? gather_tile<true>(ground, p, tile, soil) : gather_tile<false>(ground, p, tile, soil);
}

void gather(Ground& ground, const AcrossTile& tile, bool soil) {
  is_affine(ground) ? gather_across<true>(ground, tile, soil) : gather_across<false>(ground, tile, soil);
}

} // namespace

void gather_water(Ground& ground) {
  for_tiles(
      ground, 0,
      [&](Particles& p, const ParticleRange&, std::size_t tile) {
        if (p.traits.flowing)
          gather(ground, p, tile, false);
      },
      [&](Particles&, const AcrossTile& tile) { gather(ground, tile, false); });
}

void gather_mixture(Ground& ground, Particles& p, std::size_t tile) {
  gather(ground, p, tile, true);
}

void gather_mixture(Ground& ground, const AcrossTile& tile) {
  gather(ground, tile, true);
}

} // namespace tremolo::mpm_domain
