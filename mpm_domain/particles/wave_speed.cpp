#include "mpm_domain/particles/wave_speed.hpp"

#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// The larger the stress, the stiffer the soil: c_p for the density of the law, m/s.
double law_speed(Particles& set, const ParticleRange& range) {
  return materials::p_wave_speed_bound(set.law, set.points(range.begin, range.end - range.begin));
}

/// M of c_p, Pa
double p_modulus(const Particles& set, double speed) {
  return materials::elasticity(set.law).density * speed * speed;
}

} // namespace

FastestWaves fastest_waves(Particles& set, const ParticleRange& range) {
  const double speed = law_speed(set, range) * std::sqrt(set.relaxation.unrelaxed());
  const double skeleton = speed * std::sqrt(materials::elasticity(set.law).density / set.density);
  if (!set.traits.wet)
    return {skeleton, skeleton};
  const auto speeds = materials::saturated_speeds(p_modulus(set, speed), set.water->pores, set.water->fluid);
  return {set.traits.flowing ? speeds.fast : speeds.undrained, skeleton};
}

Impedances impedances(Particles& set, std::size_t k) {
  const materials::Elasticity& law = materials::elasticity(set.law);
  const double c_p = law_speed(set, {k, k + 1});
  const double c_s = c_p * law.s_wave_speed() / law.p_wave_speed(); // Poisson's ratio stays the same
  if (!set.water && set.density == law.density)
    return {law.density * c_p, law.density * c_s, law.density};
  const double m = p_modulus(set, c_p);
  const double g = p_modulus(set, c_s);
  const double density =
      set.water ? materials::saturated_density(set.water->pores, set.water->fluid) : set.density;
  const double q = set.traits.wet ? materials::pore_stiffness(set.water->pores, set.water->fluid) : 0.0;
  return {std::sqrt(density * (m + q)), std::sqrt(density * g), density};
}

} // namespace tremolo::mpm_domain
