#pragma once

// Ground, waves and errors of the tests of the marched column at an angle.

#include "freefield/marched/marched_column.hpp"
#include "tests/support/reference_table.hpp"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

namespace tremolo::freefield::testing {

constexpr double degree = std::numbers::pi / 180.0;

/// A plane wave with its particle velocity along (cos, -sin), SV, or (sin, cos), P.
struct PlaneWave {
  double angle_deg = 0.0;
  bool shear = true;
  std::function<double(double)> velocity; ///< m/s, at the base

  InputVelocity input() const {
    const double c = std::cos(angle_deg * degree), s = std::sin(angle_deg * degree);
    return [*this, c, s](double t) {
      const double v = velocity(t);
      return shear ? Velocity{v * c, -v * s} : Velocity{v * s, v * c};
    };
  }
  double slowness(const materials::Elasticity& rock) const {
    return std::sin(angle_deg * degree) / (shear ? rock.s_wave_speed() : rock.p_wave_speed());
  }
};

inline double ricker(double t, double frequency, double centre, double peak) {
  const double a = std::pow(std::numbers::pi * frequency * (t - centre), 2);
  return peak * (1.0 - 2.0 * a) * std::exp(-a);
}

inline materials::Elasticity elastic(double density, double vs, double poisson) {
  return {.density = density, .young = 2.0 * density * vs * vs * (1.0 + poisson), .poisson = poisson};
}

/// Saturated soil of a porosity and a speed of S waves, of grains of 2650 kg/m3.
inline Layer wet(double thickness, double porosity, double vs, double poisson, double permeability,
                 materials::Drainage drainage = materials::Drainage::coupled) {
  const materials::PoreSpace pores{porosity, 2650.0, permeability, drainage};
  Layer layer{thickness, elastic(materials::saturated_density(pores, {}), vs, poisson)};
  layer.pores = pores;
  return layer;
}

/// 20 m of saturated soil on rock, water up to the surface at y = 20 m.
inline Profile wet_ground(materials::Drainage drainage = materials::Drainage::coupled) {
  return {.surface_level = 20.0,
          .layers = {wet(8.0, 0.42, 150.0, 0.3, 1e-3, drainage), wet(12.0, 0.35, 280.0, 0.3, 1e-4, drainage)},
          .half_space = materials::Elasticity::from_wave_speeds(2400.0, 760.0, 1900.0),
          .gravity = 9.81,
          .water = WaterTable{20.0, {}}};
}

/// Rock of dry cases.
inline materials::Elasticity rock() {
  return materials::Elasticity::from_wave_speeds(2400.0, 760.0, 1400.0);
}

inline Profile dry_ground() {
  return {.surface_level = 20.0,
          .layers = {{8.0, elastic(1800.0, 150.0, 0.3)}, {12.0, elastic(2000.0, 300.0, 0.35)}},
          .half_space = rock()};
}

/// A column under a wave whose steps end at multiples of an interval.
inline MarchedColumn marched(const Profile& profile, const PlaneWave& wave, double h, double interval,
                             double share = 0.8, const Damping& damping = {}) {
  const double slowness = wave.slowness(profile.half_space);
  const double steps = std::ceil(interval / (share * marched_step_limit(profile, h, slowness, damping)));
  return {profile,
          {.max_element_size = h, .time_step = interval / steps, .slowness_x = slowness, .damping = damping},
          wave.input()};
}

/// The root of the sum of squares of differences over that of the exact values.
class RelativeError {
public:
  void add(double computed, double exact) {
    difference_ += (computed - exact) * (computed - exact);
    size_ += exact * exact;
  }
  double value() const { return std::sqrt(difference_ / size_); }

private:
  double difference_ = 0.0, size_ = 0.0;
};

/// Marches a column to a time.
inline void march_to(Column& column, double time) {
  while (column.time() < time - 1e-9)
    column.step();
}

} // namespace tremolo::freefield::testing
