#pragma once

// The phases that particles carry to the grid: grains, and water that flows between them. In NodeFields the
// sums of each are in the order mass, momentum, force.

#include "mpm_domain/particles/water/pore_volume.hpp"
#include "mpm_domain/strain/total_stress.hpp"
#include "mpm_domain/transfer/chunk_weights.hpp"

#include <array>
#include <vector>

namespace tremolo::mpm_domain {

/// The arrays of a chunk of particles and of a window's sums, as pointers to their first element. The
/// compiler would load the pointer inside a std::vector again after every store.
struct Arrays {
  const double *mass, *volume, *vx, *vy, *bxx, *bxy, *byx, *byy, *sxx, *syy, *sxy;
  double* sums; ///< [field][row][column], from the field on that takes `mass`
  const double *cross_x = nullptr, *cross_y = nullptr; ///< of sets with bilinear velocity
  double buoyancy = 0.0;                               ///< of soil under water, N/kg
  double grains_per_mass = 0.0;                        ///< of soil with water, c (pore_water.hpp), m3/kg
  double resistance = 0.0;                             ///< of water that flows, rho_f g/k, Pa s/m2
  CellRuns* runs = nullptr; ///< take the shares of pore volumes, if these are summed up
  std::size_t begin = 0;    ///< the first of the particles

  double* of(Sum field) const { return sums + static_cast<std::size_t>(field) * window_nodes; }
  /// Where the sums of a field of flowing water stand.
  double* of_water(Sum field) const {
    return of(field) - static_cast<std::size_t>(Sum::water_mass) * window_nodes;
  }
};

/// Numbers that a chunk of particles does not carry.
struct ChunkStore {
  std::array<double, chunk> mass, xx, yy, xy;
};

/// A column from a particle on; sets without it have no such array.
inline const double* column_from(const std::vector<double>& column, std::size_t first) {
  return column.empty() ? nullptr : &column[first];
}

/// Variation of velocity around a particle.
enum class Around { uniform, affine, bilinear };

/// Forces on a phase: its whole stress and its weight, or a pressure alone.
enum class Pull { stress_and_weight, pressure };

/// The numbers of one particle.
struct ParticleValues {
  double mass, vx, vy, bxx, bxy, byx, byy;
  TotalStress stress;
};

/// The phase that moves with the particles: grains, and pore water that does not flow. Their sums begin with
/// Sum::mass. The forces are those on soil and water together.
struct SoilPhase {
  static constexpr Sum first_sum = Sum::mass;
  static constexpr Pull pull = Pull::stress_and_weight;
  static constexpr std::size_t scalars = 0; ///< numbers that are summed up beside the forces

  /// @param store  takes the stress of forces where it is not that of the law alone
  template <bool force>
  static Arrays arrays(const Particles& p, std::size_t first, std::size_t count, double* window,
                       ChunkStore& store) {
    Arrays a{&p.mass[first],
             &p.volume[first],
             &p.vx[first],
             &p.vy[first],
             column_from(p.bxx, first),
             column_from(p.bxy, first),
             column_from(p.byx, first),
             column_from(p.byy, first),
             &p.sxx[first],
             &p.syy[first],
             &p.sxy[first],
             window};
    if constexpr (force)
      if (has_more_than_law_stress(p)) {
        by_fours(0, count, [&](std::size_t c, auto group) {
          const auto [xx, yy, xy] = total_stress(p, first + c, group);
          group.store(&store.xx[c], xx);
          group.store(&store.yy[c], yy);
          group.store(&store.xy[c], xy);
        });
        a.sxx = store.xx.data();
        a.syy = store.yy.data();
        a.sxy = store.xy.data();
      }
    return a;
  }

  template <bool affine>
  static ParticleValues of(const Particles& p, std::size_t k) {
    ParticleValues v{p.mass[k], p.vx[k], p.vy[k], 0.0, 0.0, 0.0, 0.0, total_stress(p, k)};
    if constexpr (affine) {
      v.bxx = p.bxx[k];
      v.bxy = p.bxy[k];
      v.byx = p.byx[k];
      v.byy = p.byy[k];
    }
    return v;
  }
};

/// Water that flows. Its force is that of the excess pressure per unit of water volume; it has no weight,
/// since the pressure is that beyond the one of undisturbed water.
struct WaterPhase {
  static constexpr Sum first_sum = Sum::water_mass;
  static constexpr Pull pull = Pull::pressure;
  static constexpr std::size_t scalars = 2; ///< the volume of the soil, and that times rho_f g/k
  static constexpr auto first_scalar = static_cast<std::size_t>(Sum::wet_volume);

  template <typename Group>
  static std::array<Lanes, scalars> scalars_of(const Particles& p, std::size_t k, Group group) {
    const Lanes volume = group.load(&p.volume[k]);
    return {volume, p.water->resistance() * volume};
  }

  template <bool force>
  static Arrays arrays(const Particles& p, std::size_t first, std::size_t count, double* window,
                       ChunkStore& store) {
    const PoreWater& water = *p.water;
    by_fours(0, count, [&](std::size_t c, auto group) {
      const Lanes volume = group.load(&p.volume[first + c]);
      group.store(&store.mass[c],
                  water.fluid.density * (volume - water.grains_per_mass * group.load(&p.mass[first + c])));
      if constexpr (force) {
        const Lanes excess = excess_pressure(p, first + c, group);
        group.store(&store.xx[c], -excess);
        group.store(&store.xy[c], Lanes{});
      }
    });
    return {store.mass.data(),
            &p.volume[first],
            &p.wx[first],
            &p.wy[first],
            column_from(p.wbxx, first),
            column_from(p.wbxy, first),
            column_from(p.wbyx, first),
            column_from(p.wbyy, first),
            store.xx.data(),
            store.xx.data(),
            store.xy.data(),
            window + static_cast<std::size_t>(first_sum) * window_nodes};
  }

  template <bool affine>
  static ParticleValues of(const Particles& p, std::size_t k) {
    const PoreWater& water = *p.water;
    const double excess = excess_pressure(p, k);
    ParticleValues v{water.fluid.density * (p.volume[k] - water.grains_per_mass * p.mass[k]),
                     p.wx[k],
                     p.wy[k],
                     0.0,
                     0.0,
                     0.0,
                     0.0,
                     {-excess, -excess, 0.0}};
    if constexpr (affine) {
      v.bxx = p.wbxx[k];
      v.bxy = p.wbxy[k];
      v.byx = p.wbyx[k];
      v.byy = p.wbyy[k];
    }
    return v;
  }
};

/// Buoyancy (N/m) of a group of submerged particles of a set from k on, and their pore volume V n (m2) where
/// the pressure follows the change of volume.
template <typename Group>
std::array<Lanes, 2> numbers_of_water(const Particles& p, std::size_t k, Group group, double gravity) {
  const Lanes buoyancy = (1.0 - p.weight_share) * gravity * group.load(&p.mass[k]);
  return {buoyancy, takes_pressure(p) ? pore_volume(p, k, group) : Lanes{}};
}

} // namespace tremolo::mpm_domain
