#pragma once

// Updates stress, state and volume of particles from the displacement gradient of a step, a chunk of
// particles at a time.

#include "materials/law/law.hpp"
#include "mpm_domain/kernel/lanes.hpp"
#include "mpm_domain/kernel/particle_boxes.hpp"
#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/strain/gather_sums.hpp"
#include "mpm_domain/strain/relaxation_stress.hpp"
#include "mpm_domain/strain/viscous_stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tremolo::mpm_domain {

/// Number of particles whose increments are passed from the grid to the law at a time.
inline constexpr std::size_t strain_chunk_size = 128;

using ChunkField = std::array<double, strain_chunk_size>;

struct Increments {
  ChunkField exx, eyy, gxy, wxy;
  ChunkField plastic; ///< plastic work per volume
};

/// sigma : de of a group of particles from k on, whose increments begin at `c`, J/m3
template <typename Group>
[[gnu::always_inline]] inline Lanes work_density(const Particles& p, std::size_t k, const Increments& inc,
                                                 std::size_t c, Group group) {
  return group.load(&p.sxx[k]) * load(&inc.exx[c]) + group.load(&p.syy[k]) * load(&inc.eyy[c]) +
         group.load(&p.sxy[k]) * load(&inc.gxy[c]);
}

/// Sums over a range of particles, one in each of four lanes.
struct LaneSums {
  Lanes total{};        ///< work of the stresses, J/m
  Lanes plastic{};      ///< the part of it on plastic strain, J/m
  Lanes max_speed2{};   ///< square of the largest speed, m2/s2
  double viscous = 0.0; ///< work of the stresses of damping, J/m

  GatherSums collected() const {
    const Lanes& m = max_speed2;
    return {sum(total) - sum(plastic), sum(plastic), viscous,
            std::sqrt(std::max(std::max(m[0], m[1]), std::max(m[2], m[3])))};
  }
};

/// Strain and rotation increments about the middle of the step (Hughes and Winget 1980), A (I + A/2)^-1 with
/// A = dt grad u, here to second order: A - A^2/2. About the beginning of the step, a rotation by theta would
/// look like a contraction by theta^2/2. Also books the work of the stress before the update, half of the
/// trapezoidal rule.
template <typename Group>
[[gnu::always_inline]] inline void take_strain(const Particles& p, std::size_t k, Group group,
                                               const DisplacementGradient<Lanes>& a, std::size_t c,
                                               Increments& inc, LaneSums& sums) {
  const auto& [xx, xy, yx, yy] = a;
  const Lanes across = 0.5 * xy * yx;
  const Lanes half_rest = 1.0 - 0.5 * (xx + yy);
  store(&inc.exx[c], xx - 0.5 * xx * xx - across);
  store(&inc.eyy[c], yy - 0.5 * yy * yy - across);
  store(&inc.gxy[c], half_rest * (xy + yx));
  store(&inc.wxy[c], 0.5 * half_rest * (yx - xy));
  store(&inc.plastic[c], Lanes{});
  sums.total += 0.5 * group.load(&p.volume[k]) * work_density(p, k, inc, c, group);
}

/// Lets the boxes of a group of particles follow the soil.
template <typename Group>
[[gnu::always_inline]] inline void deform_boxes(Particles& p, std::size_t k, Group group,
                                                const DisplacementGradient<Lanes>& a) {
  const BoxMoments<Lanes> box =
      deformed<Lanes>({group.load(&p.box_xx[k]), group.load(&p.box_xy[k]), group.load(&p.box_yy[k])}, a);
  group.store(&p.box_xx[k], box.xx);
  group.store(&p.box_xy[k], box.xy);
  group.store(&p.box_yy[k], box.yy);
}

/// Updates stress and state of a chunk of soil with constant damping by its law, and that of its mechanisms.
/// @returns the work of the mechanisms' stress, J/m
[[gnu::noinline]] inline double update_relaxing(Particles& p, std::size_t begin, materials::Points points,
                                                const Increments& moved, double dt) {
  const TurningStrain all{points.dexx, points.deyy, points.dgxy, points.dwxy};
  ChunkField exx, eyy, gxy, sxx, syy, sxy;
  see_share(p, points.count, all, exx.data(), eyy.data(), gxy.data());
  std::copy_n(points.sxx, points.count, sxx.begin());
  std::copy_n(points.syy, points.count, syy.begin());
  std::copy_n(points.sxy, points.count, sxy.begin());
  points.dexx = exx.data();
  points.deyy = eyy.data();
  points.dgxy = gxy.data();
  materials::update(p.law, points);
  // A law counts plastic work on the share of the strain that it sees.
  for (std::size_t c = 0; c < points.count; ++c)
    points.plastic_work[c] /= p.relaxation.relaxed;
  return relax(p, {begin, begin + points.count}, {sxx.data(), syy.data(), sxy.data()}, all,
               {moved.exx.data(), moved.eyy.data(), moved.gxy.data(), moved.wxy.data()}, dt);
}

/// Updates stress and state of a chunk by its law, then books the other half of the work and updates volumes.
/// @param seen   the increments that the law sees
/// @param moved  the increments of the particles' own motion: work and volumes follow them
/// @param dt     length of the step, s
[[gnu::noinline]] inline void strain_chunk(Particles& p, std::size_t begin, std::size_t count,
                                           Increments& seen, const Increments& moved, double dt,
                                           LaneSums& sums) {
  materials::Points points = p.points(begin, count);
  points.plastic_work = seen.plastic.data();
  points.dexx = seen.exx.data();
  points.deyy = seen.eyy.data();
  points.dgxy = seen.gxy.data();
  points.dwxy = seen.wxy.data();
  if (p.relaxation.acts()) {
    sums.viscous += update_relaxing(p, begin, points, moved, dt);
  } else {
    ChunkField ratios;
    const bool varies = p.traits.damped && materials::traits(p.law).follows_pressure;
    if (varies)
      materials::update_and_find_stiffness(p.law, points, ratios.data());
    else
      materials::update(p.law, points);
    if (p.traits.damped)
      sums.viscous +=
          damp(p, {begin, begin + count}, {seen.exx.data(), seen.eyy.data(), seen.gxy.data()},
               {moved.exx.data(), moved.eyy.data(), moved.gxy.data()}, varies ? ratios.data() : nullptr, dt);
  }
  by_fours(0, count, [&](std::size_t c, auto group) {
    const std::size_t k = begin + c;
    const Lanes before = group.load(&p.volume[k]);
    const Lanes dilation = load(&moved.exx[c]) + load(&moved.eyy[c]);
    const Lanes volume = before * growth(dilation);
    sums.total += 0.5 * volume * work_density(p, k, moved, c, group);
    sums.plastic += 0.5 * (before + volume) * load(&seen.plastic[c]);
    group.store(&p.volume[k], volume);
  });
}

} // namespace tremolo::mpm_domain
