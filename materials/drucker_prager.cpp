#include "materials/drucker_prager.hpp"

#include "materials/elastic_parameters.hpp"
#include "materials/objective_rate.hpp"
#include "materials/parameter_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace tremolo::materials {
namespace {

/// Points handled together: their out-of-plane strain may be a block of zeros.
constexpr std::size_t block_size = 256;
constexpr std::array<double, block_size> no_strain = {};

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

/// One step of points [begin, begin + count): elastic trial, then return along D times the flow direction,
///
//      q <- q - G l,    p <- p - K eta' l,    l = f/(G + K eta eta'),
///
/// or to the apex where q would become negative. No branch, so that it runs on vectors.
void move_block(const DruckerPrager& law, const Cone& cone, const Points& points, std::size_t begin,
                std::size_t count) {
  const double lame = law.elastic.lame();
  const double shear = law.elastic.shear_modulus();
  const double bulk = law.elastic.bulk_modulus();
  const double relaxation = shear + bulk * cone.slope * cone.dilatancy;
  const double apex = std::min(cone.apex, std::numeric_limits<double>::max());
  double* __restrict sxx = points.sxx + begin;
  double* __restrict syy = points.syy + begin;
  double* __restrict szz = points.szz + begin;
  double* __restrict sxy = points.sxy + begin;
  double* __restrict plastic_strain = points.state + begin;
  double* __restrict plastic_work = points.plastic_work + begin;
  const double* __restrict dexx = points.dexx + begin;
  const double* __restrict deyy = points.deyy + begin;
  const double* __restrict dgxy = points.dgxy + begin;
  const double* __restrict dwxy = points.dwxy + begin;
  const double* __restrict dezz = points.dezz == nullptr ? no_strain.data() : points.dezz + begin;
  for (std::size_t i = 0; i < count; ++i) {
    const InPlaneStress first = rotated({sxx[i], syy[i], sxy[i]}, dwxy[i]);
    const double pressure = lame * (dexx[i] + deyy[i] + dezz[i]);
    const double xx = first.xx + pressure + 2.0 * shear * dexx[i];
    const double yy = first.yy + pressure + 2.0 * shear * deyy[i];
    const double zz = szz[i] + pressure + 2.0 * shear * dezz[i];
    const double xy = first.xy + shear * dgxy[i];

    const double p = (xx + yy + zz) / 3.0;
    const double dxx = xx - p;
    const double dyy = yy - p;
    const double dzz = zz - p;
    const double q = std::sqrt(0.5 * (dxx * dxx + dyy * dyy + dzz * dzz) + xy * xy);
    const double f = q + cone.slope * p - cone.strength;
    const double multiplier = std::max(f, 0.0) / relaxation;
    const double q_cone = q - shear * multiplier;
    const bool yields = f > 0.0;
    const bool beyond = q_cone < 0.0;
    const double q_last = beyond ? 0.0 : q_cone;
    const double p_last = beyond ? apex : p - bulk * cone.dilatancy * multiplier;
    const double kept = q_last / std::max(q, std::numeric_limits<double>::min());

    const double last_xx = yields ? p_last + kept * dxx : xx;
    const double last_yy = yields ? p_last + kept * dyy : yy;
    const double last_zz = yields ? p_last + kept * dzz : zz;
    const double last_xy = yields ? kept * xy : xy;
    // The mean stress of the step on its plastic strain, as the trapezoidal rule takes the whole work.
    const double p_mean = (first.xx + first.yy + szz[i] + 3.0 * p_last) / 6.0;
    const double along = (first.xx + last_xx) * dxx + (first.yy + last_yy) * dyy + (szz[i] + last_zz) * dzz +
                         2.0 * (first.xy + last_xy) * xy; // mean stress with the trial's deviator, twice
    const double work = (1.0 - kept) * along / (4.0 * shear) + p_mean * (p - p_last) / bulk;
    plastic_work[i] += yields ? work : 0.0;
    plastic_strain[i] += yields ? (q - q_last) / (std::numbers::sqrt3 * shear) : 0.0;
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

void update(const DruckerPrager& law, const Points& points) {
  const Cone made = cone(law);
  for (std::size_t begin = 0; begin < points.count; begin += block_size) {
    move_block(law, made, points, begin, std::min(block_size, points.count - begin));
  }
}

void validate(const DruckerPrager& law) {
  constexpr double steepest = 89.0 * std::numbers::pi / 180.0;
  check(law.elastic);
  check_range("cohesion", law.cohesion, 0.0, std::numeric_limits<double>::max());
  check_range("friction", law.friction, 0.0, steepest);
  check_range("dilation", law.dilation, 0.0, law.friction);
  if (law.cohesion == 0.0 && law.friction == 0.0) {
    throw std::invalid_argument("cohesion and friction are both 0: the soil would have no strength");
  }
}

std::vector<ParameterValue> parameters(const DruckerPrager& law) {
  const Cone made = cone(law);
  std::vector<ParameterValue> values = elastic_parameters(law.elastic);
  values.push_back({"cohesion", law.cohesion, "Pa", "cohesion c", "given"});
  values.push_back({"friction", law.friction, "rad", "friction angle phi", "given"});
  values.push_back({"dilation", law.dilation, "rad", "dilation angle psi", "given"});
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
