#include "materials/plastic/mohr_coulomb.hpp"

#include "materials/elastic/elastic_parameters.hpp"
#include "materials/elastic/elastic_trial.hpp"
#include "materials/law/parameter_check.hpp"
#include "materials/law/plastic_work.hpp"
#include "materials/plastic/mohr_coulomb_main_plane.hpp"
#include "materials/plastic/mohr_coulomb_softening.hpp"
#include "materials/plastic/plastic_strain.hpp"
#include "materials/plastic/reduced_friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace tremolo::materials {
namespace {

/// Points handled together: their stress stays in the first-level cache between the passes.
constexpr std::size_t block_size = PlasticPoints::capacity;

bool outside(double s1, double s3, const Strength& strength) {
  return yield_function(s1, s3, strength) > 0.0 || s1 > strength.tension;
}

/// Stress of a point by principal values: two in the plane, with twice their direction's angle, and s_zz.
struct Spectrum {
  double larger = 0.0; ///< in-plane
  double smaller = 0.0;
  double out_of_plane = 0.0;
  double cosine2 = 1.0;
  double sine2 = 0.0;
};

Spectrum spectrum(double sxx, double syy, double szz, double sxy) {
  const double mean = 0.5 * (sxx + syy);
  const double half = 0.5 * (sxx - syy);
  const double radius = std::sqrt(half * half + sxy * sxy);
  Spectrum s{mean + radius, mean - radius, szz, 1.0, 0.0};
  if (radius > 0.0) {
    s.cosine2 = half / radius;
    s.sine2 = sxy / radius;
  }
  return s;
}

/// The place of s_zz among the sorted principal stresses: 0, 1 or 2.
std::size_t place_of_szz(const Spectrum& s) {
  if (s.out_of_plane > s.larger)
    return 0;
  return s.out_of_plane < s.smaller ? 2 : 1;
}

Principal sorted(const Spectrum& s, std::size_t place) {
  switch (place) {
  case 0:
    return {s.out_of_plane, s.larger, s.smaller};
  case 1:
    return {s.larger, s.out_of_plane, s.smaller};
  default:
    return {s.larger, s.smaller, s.out_of_plane};
  }
}

/// Brings point i, whose arrays hold the trial stress, back to its surface if it lies outside.
void correct(const MohrCoulomb& law, const FadingStrength& peak, const Points& points, std::size_t i) {
  const Stress trial = {points.sxx[i], points.syy[i], points.szz[i], points.sxy[i]};
  const Spectrum directions = spectrum(trial.xx, trial.yy, trial.zz, trial.xy);
  const std::size_t place = place_of_szz(directions);
  const Principal principal = sorted(directions, place);
  const double e = points.state[i];
  const bool weakened = law.softening > 0.0 && e > 0.0;
  const FadingStrength start = weakened ? strength_at(law, e) : peak;
  if (!outside(principal[0], principal[2], start.now))
    return;
  const Return end = implicit_return(law, principal, e, start);
  const double larger = end.stress[place == 0 ? 1 : 0];
  const double smaller = end.stress[place == 2 ? 1 : 2];
  const double mean = 0.5 * (larger + smaller);
  const double half = 0.5 * (larger - smaller);
  const Stress last = {mean + half * directions.cosine2, mean - half * directions.cosine2, end.stress[place],
                       half * directions.sine2};
  const Stress relaxed = {trial.xx - last.xx, trial.yy - last.yy, trial.zz - last.zz, trial.xy - last.xy};
  const StrainIncrement de = {points.dexx[i], points.deyy[i], out_of_plane_strain(points, i), points.dgxy[i]};
  points.plastic_work[i] += plastic_work(law.elastic, de, trial, relaxed);
  points.state[i] = end.plastic_strain;
  points.sxx[i] = last.xx;
  points.syy[i] = last.yy;
  points.szz[i] = last.zz;
  points.sxy[i] = last.xy;
}

/// Brings the marked points of a block back to their surface: those that end on the main plane together, the
/// others one by one. Which points are marked no processor can foretell: no branch until few are left.
void return_suspects(const MohrCoulomb& law, const FadingStrength& peak, const Points& points,
                     std::size_t begin, std::size_t count, const std::uint8_t* suspect) {
  PlasticPoints some;
  std::array<std::size_t, block_size> place;
  some.count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    place[some.count] = begin + i;
    some.count += suspect[i];
  }
  if (some.count == 0)
    return;
  for (std::size_t k = 0; k < some.count; ++k)
    some.take(points, place[k], k);
  return_to_main_plane(law, some);
  for (std::size_t k = 0; k < some.count; ++k)
    some.give(points, place[k], k);
  for (std::size_t k = 0; k < some.count; ++k)
    if (some.left[k] != 0.0)
      correct(law, peak, points, place[k]);
}

/// Marks the points of a block that are softened already or whose trial stress exceeds the peak strength.
void mark_suspects(const MohrCoulomb& law, const Strength& peak, const Points& points, std::size_t begin,
                   std::size_t count, std::uint8_t* __restrict suspect) {
  const double* __restrict sxx = points.sxx + begin;
  const double* __restrict syy = points.syy + begin;
  const double* __restrict szz = points.szz + begin;
  const double* __restrict sxy = points.sxy + begin;
  const double* __restrict e = points.state + begin;
  const double sound =
      law.softening > 0.0
          ? 0.0
          : std::numeric_limits<double>::infinity(); // largest e at which the peak strength still holds
  for (std::size_t i = 0; i < count; ++i) {
    const double mean = 0.5 * (sxx[i] + syy[i]);
    const double half = 0.5 * (sxx[i] - syy[i]);
    const double radius = std::sqrt(half * half + sxy[i] * sxy[i]);
    const double s1 = std::max(mean + radius, szz[i]);
    const double s3 = std::min(mean - radius, szz[i]);
    const bool yields = (yield_function(s1, s3, peak) > 0.0) | (s1 > peak.tension);
    suspect[i] = static_cast<std::uint8_t>(yields | (e[i] > sound));
  }
}

void check_softening_pair(const char* quantity, double peak, double residual, double high) {
  check_range(fmt::format("{}_peak", quantity), peak, 0.0, high);
  check_range(fmt::format("{}_residual", quantity), residual, 0.0, peak);
}

} // namespace

Traits traits(const MohrCoulomb& law) {
  return {.name = "mohr_coulomb",
          .response = Response::plastic,
          .softening = law.softening,
          .unlimited_tension = law.friction_peak == 0.0 && !law.tension_cutoff,
          .in_plane = true};
}

std::span<const StateVariable> state_variables(const MohrCoulomb& /*law*/) {
  return plastic_strain_state;
}

/// sigma_1 - sigma_3 = 2 c cos(phi) + 2 p sin(phi), where sigma_zz lies between them.
std::vector<StrengthLine> strength_lines(const MohrCoulomb& law) {
  return {{"failure", [cohesion = law.cohesion_peak, friction = law.friction_peak](double p) {
             return 2.0 * (cohesion * std::cos(friction) + p * std::sin(friction));
           }}};
}

void update(const MohrCoulomb& law, const Points& points) {
  const FadingStrength peak = strength_at(law, 0.0);
  std::array<std::uint8_t, block_size> suspect{};
  for (std::size_t begin = 0; begin < points.count; begin += block_size) {
    const std::size_t count = std::min(block_size, points.count - begin);
    elastic_trial(law.elastic, points, begin, begin + count);
    mark_suspects(law, peak.now, points, begin, count, suspect.data());
    return_suspects(law, peak, points, begin, count, suspect.data());
  }
}

void validate(const MohrCoulomb& law) {
  constexpr double steepest = 89.0 * std::numbers::pi / 180.0;
  check(law.elastic);
  check_softening_pair("cohesion", law.cohesion_peak, law.cohesion_residual,
                       std::numeric_limits<double>::max());
  check_softening_pair("friction", law.friction_peak, law.friction_residual, steepest);
  check_softening_pair("dilation", law.dilation_peak, law.dilation_residual, law.friction_peak);
  check_range("dilation_residual", law.dilation_residual, 0.0, law.friction_residual);
  check_range("softening", law.softening, 0.0, std::numeric_limits<double>::max());
  if (law.cohesion_residual == 0.0 && law.friction_residual == 0.0) {
    throw std::invalid_argument(
        "cohesion_residual and friction_residual are both 0: the soil would have no strength");
  }
  if (law.tension_cutoff)
    check_range("tension_cutoff", *law.tension_cutoff, 0.0, std::numeric_limits<double>::max());
}

std::vector<ParameterValue> parameters(const MohrCoulomb& law) {
  std::vector<ParameterValue> values = elastic_parameters(law.elastic);
  values.push_back({"cohesion_peak", law.cohesion_peak, "Pa", "cohesion before softening", "given"});
  values.push_back({"cohesion_residual", law.cohesion_residual, "Pa", "cohesion after softening", "given"});
  values.push_back({"friction_peak", law.friction_peak, "rad", "friction angle before softening", "given"});
  values.push_back(
      {"friction_residual", law.friction_residual, "rad", "friction angle after softening", "given"});
  values.push_back({"dilation_peak", law.dilation_peak, "rad", "dilation angle before softening", "given"});
  values.push_back(
      {"dilation_residual", law.dilation_residual, "rad", "dilation angle after softening", "given"});
  values.push_back({"softening", law.softening, "1", "eta: rate of decay with plastic strain", "given"});
  values.push_back({"tension_cutoff", strength_at(law, 0.0).now.tension, "Pa",
                    "largest tensile stress before softening",
                    law.tension_cutoff ? "given; at most c cot(phi)" : "default: apex c cot(phi)"});
  return values;
}

MohrCoulomb without_softening(MohrCoulomb law) {
  law.softening = 0.0;
  return law;
}

std::optional<MohrCoulomb> with_reduced_strength(MohrCoulomb law, double factor) {
  law.cohesion_peak /= factor;
  law.cohesion_residual /= factor;
  law.friction_peak = reduced_friction(law.friction_peak, factor);
  law.friction_residual = reduced_friction(law.friction_residual, factor);
  law.dilation_peak = std::min(law.dilation_peak, law.friction_peak);
  law.dilation_residual = std::min(law.dilation_residual, law.friction_residual);
  return law;
}

MohrCoulomb cohesionless(const Elasticity& elastic, double friction) {
  return {.elastic = elastic, .friction_peak = friction, .friction_residual = friction};
}

MohrCoulomb for_cell_size(MohrCoulomb law, double cell_size, double reference_size) {
  check_positive("cell size", cell_size);
  check_positive("reference size", reference_size);
  law.softening *= cell_size / reference_size;
  return law;
}

} // namespace tremolo::materials
