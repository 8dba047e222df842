#include "materials/plastic/drucker_prager.hpp"

#include "materials/elastic/elastic_parameters.hpp"
#include "materials/law/parameter_check.hpp"
#include "materials/plastic/plastic_strain.hpp"
#include "materials/plastic/reduced_friction.hpp"
#include "materials/tensor/independent_loop.hpp"
#include "materials/tensor/objective_rate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace tremolo::materials {
namespace {

/// eta of the cone through Mohr-Coulomb with associated flow.
double associated_slope(double sine, ConeMatch match) {
  switch (match) {
  case ConeMatch::triaxial_compression:
    return 6.0 * sine / (std::numbers::sqrt3 * (3.0 - sine));
  case ConeMatch::triaxial_extension:
    return 6.0 * sine / (std::numbers::sqrt3 * (3.0 + sine));
  default:
    return 3.0 * sine / std::sqrt(9.0 + 3.0 * sine * sine);
  }
}

/// eta / sin(phi), which stays finite for phi = 0.
double slope_over_sine(double sine, double dilatancy, ConeMatch match) {
  switch (match) {
  case ConeMatch::triaxial_compression:
    return 6.0 / (std::numbers::sqrt3 * (3.0 - sine));
  case ConeMatch::triaxial_extension:
    return 6.0 / (std::numbers::sqrt3 * (3.0 + sine));
  default:
    return 1.0 / (std::sqrt(1.0 - dilatancy * dilatancy / 3.0) + dilatancy * sine / 3.0);
  }
}

/// One step of all points: elastic trial, then return along D times the flow direction,
///
//      q <- q - G l,    p <- p - K eta' l,    l = f/(G + K eta eta'),
///
/// or to the apex where q would become negative, which is where p would pass it. No branch, so that it runs
/// on vectors.
template <bool plane_strain>
void move(const DruckerPrager& law, const Points& points) {
  const Cone made = cone(law);
  const double lame = law.elastic.lame();
  const double shear = law.elastic.shear_modulus();
  const double bulk = law.elastic.bulk_modulus();
  const double slope = made.slope;
  const double strength = made.strength;
  const double bulk_flow = bulk * made.dilatancy;
  const double apex = made.apex;
  const double softness = 1.0 / (shear + bulk_flow * made.slope);
  const double per_4_shear = 0.25 / shear;
  const double per_2_bulk = 0.5 / bulk;
  const double per_root3_shear = 1.0 / (std::numbers::sqrt3 * shear);
  double* __restrict sxx = points.sxx;
  double* __restrict syy = points.syy;
  double* __restrict szz = points.szz;
  double* __restrict sxy = points.sxy;
  double* __restrict plastic_strain = points.state;
  double* __restrict plastic_work = points.plastic_work;
  const double* __restrict dexx = points.dexx;
  const double* __restrict deyy = points.deyy;
  const double* __restrict dgxy = points.dgxy;
  const double* __restrict dwxy = points.dwxy;
  const double* __restrict dezz = points.dezz;
  TREMOLO_INDEPENDENT_LOOP
  for (std::size_t i = 0; i < points.count; ++i) {
    const InPlaneStress first = rotated({sxx[i], syy[i], sxy[i]}, dwxy[i]);
    const double ezz = plane_strain ? 0.0 : dezz[i];
    const double pressure = lame * (dexx[i] + deyy[i] + ezz);
    const double xx = first.xx + pressure + 2.0 * shear * dexx[i];
    const double yy = first.yy + pressure + 2.0 * shear * deyy[i];
    const double zz = szz[i] + pressure + 2.0 * shear * ezz;
    const double xy = first.xy + shear * dgxy[i];

    const double p = (xx + yy + zz) / 3.0;
    const double dxx = xx - p;
    const double dyy = yy - p;
    const double dzz = zz - p;
    const double q = std::sqrt(0.5 * (dxx * dxx + dyy * dyy + dzz * dzz) + xy * xy);
    const double f = q + slope * p - strength;
    const double multiplier = std::max(f, 0.0) * softness;
    const double q_lost = std::min(shear * multiplier, q);
    const double share = q_lost / std::max(q, std::numeric_limits<double>::min());
    const double p_last = std::min(p - bulk_flow * multiplier, apex);
    const double p_lost = p - p_last;

    const double last_xx = xx - share * dxx - p_lost;
    const double last_yy = yy - share * dyy - p_lost;
    const double last_zz = zz - share * dzz - p_lost;
    const double last_xy = xy - share * xy;
    // The mean stress of the step on its plastic strain, as the trapezoidal rule takes the whole work.
    const double p_sum = (first.xx + first.yy + szz[i]) / 3.0 + p_last;
    const double along = (first.xx + last_xx) * dxx + (first.yy + last_yy) * dyy + (szz[i] + last_zz) * dzz +
                         2.0 * (first.xy + last_xy) * xy;
    plastic_work[i] += share * along * per_4_shear + p_sum * p_lost * per_2_bulk;
    plastic_strain[i] += q_lost * per_root3_shear;
    sxx[i] = last_xx;
    syy[i] = last_yy;
    szz[i] = last_zz;
    sxy[i] = last_xy;
  }
}

} // namespace

Cone cone(const DruckerPrager& law) {
  const double sine = std::sin(law.friction);
  Cone made;
  made.dilatancy = associated_slope(std::sin(law.dilation), law.match);
  const double ratio = slope_over_sine(sine, made.dilatancy, law.match);
  made.slope = ratio * sine;
  made.strength = ratio * std::cos(law.friction) * law.cohesion;
  made.apex =
      sine > 0.0 ? law.cohesion * std::cos(law.friction) / sine : std::numeric_limits<double>::infinity();
  return made;
}

Traits traits(const DruckerPrager& law) {
  return {.name = "drucker_prager", .response = Response::plastic, .unlimited_tension = law.friction == 0.0};
}

std::span<const StateVariable> state_variables(const DruckerPrager& /*law*/) {
  return plastic_strain_state;
}

/// In three dimensions q = sqrt(3 J2), which is sqrt(3) times the q of the cone.
std::vector<StrengthLine> strength_lines(const DruckerPrager& law) {
  return {{"failure",
           [made = cone(law)](double p) { return std::numbers::sqrt3 * (made.strength + made.slope * p); }}};
}

void update(const DruckerPrager& law, const Points& points) {
  points.dezz == nullptr ? move<true>(law, points) : move<false>(law, points);
}

std::optional<DruckerPrager> with_reduced_strength(DruckerPrager law, double factor) {
  law.cohesion /= factor;
  law.friction = reduced_friction(law.friction, factor);
  law.dilation = std::min(law.dilation, law.friction);
  return law;
}

DruckerPrager frictionless(const Elasticity& elastic, double strength) {
  return {.elastic = elastic, .cohesion = strength};
}

namespace {

constexpr Range angle = {.low = 0.0, .high = 89.0};
constexpr std::array own_fields = {
    LawField<DruckerPrager>{{.name = "cohesion", .unit = "Pa", .meaning = "cohesion", .range = from_zero},
                            &DruckerPrager::cohesion},
    LawField<DruckerPrager>{{.name = "friction_deg",
                             .unit = "degrees",
                             .meaning = "friction angle in the test that `cone` names",
                             .range = angle},
                            &DruckerPrager::friction},
    LawField<DruckerPrager>{{.name = "dilation_deg",
                             .unit = "degrees",
                             .meaning = "dilation angle",
                             .range = angle,
                             .fallback = "0",
                             .remark = "At most the friction angle."},
                            &DruckerPrager::dilation}};

} // namespace

std::span<const LawField<DruckerPrager>> fields(const DruckerPrager& /*law*/) {
  return own_fields;
}

void validate(const DruckerPrager& law) {
  check(law.elastic);
  for (const auto& [text, field] : own_fields)
    check(text, law.*field);
  check_at_most(own_fields[2].text, law.dilation, own_fields[1].text, law.friction);
  if (law.cohesion == 0.0 && law.friction == 0.0)
    throw std::invalid_argument("cohesion and friction_deg are both 0: the soil would have no strength");
}

std::vector<ParameterValue> parameters(const DruckerPrager& law) {
  const Cone made = cone(law);
  std::vector<ParameterValue> values = elastic_parameters(law.elastic);
  for (const auto& [text, field] : own_fields)
    values.push_back(report(text, law.*field));
  const char* const matched =
      law.match == ConeMatch::triaxial_compression ? "matched to Mohr-Coulomb in triaxial compression"
      : law.match == ConeMatch::triaxial_extension ? "matched to Mohr-Coulomb in triaxial extension"
                                                   : "matched to Mohr-Coulomb in plane strain";
  values.push_back({"eta", made.slope, "1", "slope of the cone, q over p", matched});
  values.push_back({"xi_c", made.strength, "Pa", "q at p = 0", matched});
  values.push_back({"eta_dilation", made.dilatancy, "1", "slope of the plastic potential", matched});
  return values;
}

} // namespace tremolo::materials
