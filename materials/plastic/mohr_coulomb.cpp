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

constexpr Range angle = {.low = 0.0, .high = 89.0};

using Law = MohrCoulomb;
constexpr std::array own_fields = {
    LawField<Law>{
        {.name = "cohesion_peak", .unit = "Pa", .meaning = "cohesion before softening", .range = from_zero},
        &Law::cohesion_peak},
    LawField<Law>{{.name = "cohesion_residual",
                   .unit = "Pa",
                   .meaning = "cohesion after softening",
                   .range = from_zero,
                   .remark = "At most the peak."},
                  &Law::cohesion_residual},
    LawField<Law>{{.name = "friction_peak_deg",
                   .unit = "degrees",
                   .meaning = "friction angle before softening",
                   .range = angle},
                  &Law::friction_peak},
    LawField<Law>{{.name = "friction_residual_deg",
                   .unit = "degrees",
                   .meaning = "friction angle after softening",
                   .range = angle,
                   .remark = "At most the peak."},
                  &Law::friction_residual},
    LawField<Law>{{.name = "dilation_peak_deg",
                   .unit = "degrees",
                   .meaning = "dilation angle before softening",
                   .range = angle,
                   .fallback = "0",
                   .remark = "At most the friction angle."},
                  &Law::dilation_peak},
    LawField<Law>{{.name = "dilation_residual_deg",
                   .unit = "degrees",
                   .meaning = "dilation angle after softening",
                   .range = angle,
                   .fallback = "0"},
                  &Law::dilation_residual},
    LawField<Law>{{.name = "softening",
                   .unit = "1",
                   .meaning = "softening coefficient eta",
                   .range = from_zero,
                   .remark =
                       "Cohesion and angles decay from peak to residual with exp(-eta e), e the equivalent "
                       "plastic deviatoric strain. 0 keeps the peak."},
                  &Law::softening}};

/// Fields of which the first is at most the second: residual and peak, dilation and friction.
constexpr std::array<std::array<std::size_t, 2>, 5> at_most = {{{1, 0}, {3, 2}, {5, 4}, {4, 2}, {5, 3}}};

constexpr Parameter tension_cutoff = {.name = "tension_cutoff",
                                      .unit = "Pa",
                                      .meaning = "largest tensile stress",
                                      .range = from_zero,
                                      .otherwise = "the apex c cot(phi)"};
constexpr Parameter reference_size = {
    .name = "reference_size",
    .unit = "m",
    .meaning = "cell size h_ref for which `softening` holds",
    .range = above_zero,
    .otherwise = "needed where `softening` > 0",
    .remark = "eta is scaled by h/h_ref, so that the work of a shear band does not depend on the mesh."};

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

std::span<const LawField<MohrCoulomb>> fields(const MohrCoulomb& /*law*/) {
  return own_fields;
}

std::span<const Parameter> mohr_coulomb_parameters() {
  static const std::vector<Parameter> all = texts(own_fields, {tension_cutoff, reference_size});
  return all;
}

void validate(const MohrCoulomb& law) {
  check(law.elastic);
  for (const auto& [text, field] : own_fields)
    check(text, law.*field);
  for (const auto& [lower, upper] : at_most)
    check_at_most(own_fields[lower].text, law.*own_fields[lower].field, own_fields[upper].text,
                  law.*own_fields[upper].field);
  if (law.cohesion_residual == 0.0 && law.friction_residual == 0.0) {
    throw std::invalid_argument(
        "cohesion_residual and friction_residual_deg are both 0: the soil would have no strength");
  }
  if (law.tension_cutoff)
    check(tension_cutoff, *law.tension_cutoff);
}

std::vector<ParameterValue> parameters(const MohrCoulomb& law) {
  std::vector<ParameterValue> values = elastic_parameters(law.elastic);
  for (const auto& [text, field] : own_fields)
    values.push_back(report(text, law.*field));
  values.push_back(report(tension_cutoff, strength_at(law, 0.0).now.tension,
                          law.tension_cutoff ? "given; at most c cot(phi)" : "default: apex c cot(phi)"));
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
