// The state that belongs to a stress reached elastically with G_r and B_r, e.g. by gravity, and the wave
// speed and stiffness that belong to a stress.

#include "materials/sand/pdmy03/pdmy03_cone.hpp"
#include "materials/sand/pdmy03/pdmy03_state.hpp"
#include "materials/sand/pdmy03/pdmy03_stiffness.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials {
namespace {

/// Every surface that the stress lies outside of is moved along the stress until it touches it; the largest
/// of them is the active one.
void touch_surfaces(const Pdmy03& law, Pdmy03State& state, const RestingCentres& centres, const Deviator3& s,
                    double height, bool on_failure) {
  const double ratio = std::sqrt(1.5) * norm(s) / height;
  std::size_t active = on_failure ? law.surfaces : 0;
  while (active < law.surfaces && ratio > law.ratio[active + 1])
    ++active;
  state.active_surface = static_cast<double>(active);
  for (std::size_t i = 1; i <= active; ++i) {
    const Deviator3 centre = (-(1.0 - law.ratio[i] / ratio) / height) * s;
    if (i == active)
      state.active_centre = i == law.surfaces ? Deviator3{} : centre;
    else
      centres.set(i, centre);
  }
}

} // namespace

LinearElastic without_softening(const Pdmy03& law) {
  return {law.elastic};
}

std::optional<MohrCoulomb> with_reduced_strength(const Pdmy03& law, double factor) {
  return with_reduced_strength(cohesionless(law.elastic, law.friction), factor);
}

void initialise(const Pdmy03& law, const Points& points) {
  const std::size_t size = pdmy03_state_size(law.surfaces);
  const YieldCone failure = {law.ratio[law.surfaces], {}};
  for (std::size_t i = 0; i < points.count; ++i) {
    double* block = points.state + i * size;
    std::fill_n(block, size, 0.0);
    Pdmy03State state;
    const MeanAndDeviator given = split(points.sxx[i], points.syy[i], points.szz[i], points.sxy[i]);
    state.strain = (0.5 / law.elastic.shear_modulus()) * given.deviator;
    state.volume_strain = given.mean / law.elastic.bulk_modulus();

    const double mean = std::min(0.0, given.mean);
    const double height = law.residual_pressure - mean;
    const bool outside = failure.yield_function(given.deviator, height) > 0.0;
    const Deviator3 s = outside ? failure.projected(given.deviator, height) : given.deviator;
    state.zone = pdmy03_zone::never_reached;
    state.largest_pressure = -mean;
    state.initial_height = height;
    state.initial_shear_ratio = std::abs(s.xy()) / height;
    touch_surfaces(law, state, {block, law.surfaces}, s, height, outside);
    store(state, block);

    if (outside || given.mean > 0.0) {
      const auto held = components(MeanAndDeviator{mean, s});
      points.sxx[i] = held.xx;
      points.syy[i] = held.yy;
      points.szz[i] = held.zz;
      points.sxy[i] = held.xy;
    }
  }
}

double p_wave_speed_bound(const Pdmy03& law, const Points& points) {
  double least = 0.0; // trace of the stress, Pa
  for (std::size_t i = 0; i < points.count; ++i)
    least = std::min(least, points.sxx[i] + points.syy[i] + points.szz[i]);
  return law.elastic.p_wave_speed() *
         std::sqrt(pdmy03_modulus_factor(law, law.residual_pressure - least / 3.0));
}

void stiffness_ratios(const Pdmy03& law, const Points& points, double* ratios) {
  by_fours(0, points.count, [&](std::size_t i, auto group) {
    const Lanes trace = group.load(points.sxx + i) + group.load(points.syy + i) + group.load(points.szz + i);
    const Lanes height = law.residual_pressure - smaller(trace / 3.0, Lanes{});
    group.store(ratios + i, pdmy03_modulus_factor(law, height));
  });
}

} // namespace tremolo::materials
