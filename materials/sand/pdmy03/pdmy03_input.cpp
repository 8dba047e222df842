// Conversion of the user's input to the parameters in force.

#include "materials/law/parameter_check.hpp"
#include "materials/sand/pdmy03/pdmy03.hpp"
#include "materials/sand/pdmy03/pdmy03_parameters.hpp"
#include "materials/sand/pdmy03/pdmy03_surfaces.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace tremolo::materials {
namespace {

using P = Pdmy03Parameter;
constexpr double degree = std::numbers::pi / 180.0;

struct RecommendedSet {
  double relative_density;
  double density;       ///< kg/m3
  double shear_modulus; ///< Pa
  double bulk_modulus;  ///< Pa
  double friction;      ///< rad
  double phase_transformation;
  std::array<double, 5> contraction;
  std::array<double, 3> dilation;
};

// Khosravifar et al. (2018), Table 1
constexpr std::array recommended = {RecommendedSet{0.33,
                                                   1940.0,
                                                   46.9e6,
                                                   125.1e6,
                                                   25.4 * degree,
                                                   20.4 * degree,
                                                   {0.03, 5.0, 0.2, 16.0, 2.0},
                                                   {0.15, 3.0, -0.2}},
                                    RecommendedSet{0.57,
                                                   1990.0,
                                                   73.7e6,
                                                   196.8e6,
                                                   30.3 * degree,
                                                   25.3 * degree,
                                                   {0.012, 3.0, 0.4, 9.0, 0.0},
                                                   {0.3, 3.0, -0.3}},
                                    RecommendedSet{0.74,
                                                   2030.0,
                                                   94.6e6,
                                                   252.6e6,
                                                   35.8 * degree,
                                                   30.8 * degree,
                                                   {0.005, 1.0, 0.6, 4.6, -1.0},
                                                   {0.45, 3.0, -0.4}},
                                    RecommendedSet{0.87,
                                                   2060.0,
                                                   111.9e6,
                                                   298.3e6,
                                                   42.2 * degree,
                                                   37.2 * degree,
                                                   {0.001, 0.0, 0.8, 2.2, 0.0},
                                                   {0.6, 3.0, -0.5}}};

const RecommendedSet& recommended_set(double relative_density) {
  for (const RecommendedSet& set : recommended)
    if (std::abs(set.relative_density - relative_density) < 1e-9)
      return set;
  throw std::invalid_argument(fmt::format(
      "relative_density = {:g}: PDMY03 has recommended sets for 0.33, 0.57, 0.74 and 0.87 only, and "
      "they are not interpolated; take one of these, or give every parameter",
      relative_density));
}

/// Takes values one after the other and notes where they come from.
class Resolver {
public:
  explicit Resolver(Pdmy03& law) : law_(law) {}

  /// A value that is given, or stands in the recommended set.
  double pick(P parameter, const std::optional<double>& given, const std::optional<double>& table) {
    if (given)
      return from(parameter, *given, Pdmy03Origin::given);
    if (table)
      return from(parameter, *table, Pdmy03Origin::table);
    throw std::invalid_argument(fmt::format(
        "{} is missing: give it, or a relative_density of 0.33, 0.57, 0.74 or 0.87", pdmy03_name(parameter)));
  }

  /// A value that is given, or the default.
  double pick_or(P parameter, const std::optional<double>& given, double fallback) {
    return given ? from(parameter, *given, Pdmy03Origin::given)
                 : from(parameter, fallback, Pdmy03Origin::fallback);
  }

  double from(P parameter, double value, Pdmy03Origin origin) {
    law_.origins[static_cast<std::size_t>(parameter)] = origin;
    return value;
  }

private:
  Pdmy03& law_;
};

P following(P first, std::size_t k) {
  return static_cast<P>(static_cast<std::size_t>(first) + k);
}

Elasticity elasticity_of(double density, double shear, double bulk) {
  return {density, 9.0 * bulk * shear / (3.0 * bulk + shear),
          (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear))};
}

/// The angles, in degrees as users give them.
void check_angles(const Pdmy03& law) {
  constexpr double least = 1.0 * degree;
  constexpr double steepest = 65.0 * degree;
  const bool of_curve = law.origins[static_cast<std::size_t>(P::friction)] == Pdmy03Origin::curve;
  const std::string_view source = of_curve ? ", which the modulus reduction curve fixes" : "";
  if (!(law.friction >= least && law.friction <= steepest)) {
    throw std::invalid_argument(fmt::format("friction_deg = {:.4g}{}, is outside [{:g}, {:g}] degrees",
                                            law.friction / degree, source, least / degree,
                                            steepest / degree));
  }
  if (!(law.phase_transformation >= least && law.phase_transformation <= law.friction)) {
    throw std::invalid_argument(fmt::format(
        "phase_transformation_deg = {:.4g} is outside [{:g}, {:.4g}] degrees, up to friction_deg{}",
        law.phase_transformation / degree, least / degree, law.friction / degree, source));
  }
}

/// Refuses what would make the surfaces meaningless before they are built.
void check_values(const Pdmy03& law) {
  constexpr double unbounded = std::numeric_limits<double>::max();
  check(law.elastic);
  check_angles(law);
  check_range("contraction_a", law.contraction[0], 0.0, unbounded);
  check_range("contraction_b", law.contraction[1], 0.0, unbounded);
  check_range("contraction_c", law.contraction[2], 0.0, 10.0);
  check_range("contraction_d", law.contraction[3], 0.0, unbounded);
  check_range("contraction_e", law.contraction[4], -100.0, 100.0);
  check_range("dilation_a", law.dilation[0], 0.0, unbounded);
  check_range("dilation_b", law.dilation[1], 0.0, 100.0);
  check_range("dilation_c", law.dilation[2], -10.0, 10.0);
  check_positive("peak_shear_strain", law.peak_shear_strain);
  check_positive("reference_pressure", law.reference_pressure);
  check_range("pressure_exponent", law.pressure_exponent, 0.0, 1.0);
  check_range("liquefaction_1", law.liquefaction_1, 0.0, unbounded);
  check_range("liquefaction_2", law.liquefaction_2, 0.0, unbounded);
  check_positive("atmospheric_pressure", law.atmospheric_pressure);
  check_range("zero_pressure_strength", law.zero_pressure_strength, 0.0, law.reference_pressure);
}

std::size_t surface_count(double given) {
  check_range("surfaces", given, 3.0, static_cast<double>(most_pdmy03_surfaces));
  if (given != std::floor(given))
    throw std::invalid_argument(fmt::format("surfaces = {:g} must be a whole number", given));
  return static_cast<std::size_t>(given);
}

void resolve_soil(Resolver& resolver, const Pdmy03Input& input, const Pdmy03Input& table, Pdmy03& law) {
  const double shear = resolver.pick(P::shear_modulus, input.shear_modulus, table.shear_modulus);
  const double bulk = resolver.pick(P::bulk_modulus, input.bulk_modulus, table.bulk_modulus);
  check_positive("shear_modulus", shear);
  check_positive("bulk_modulus", bulk);
  law.elastic = elasticity_of(resolver.pick(P::density, input.density, table.density), shear, bulk);
  law.phase_transformation =
      resolver.pick(P::phase_transformation, input.phase_transformation, table.phase_transformation);
  for (std::size_t k = 0; k < law.contraction.size(); ++k) {
    law.contraction[k] =
        resolver.pick(following(P::contraction_a, k), input.contraction[k], table.contraction[k]);
  }
  for (std::size_t k = 0; k < law.dilation.size(); ++k)
    law.dilation[k] = resolver.pick(following(P::dilation_a, k), input.dilation[k], table.dilation[k]);
}

void resolve_defaults(Resolver& resolver, const Pdmy03Input& input, Pdmy03& law) {
  law.peak_shear_strain = resolver.pick_or(P::peak_shear_strain, input.peak_shear_strain, 0.1);
  law.reference_pressure = resolver.pick_or(P::reference_pressure, input.reference_pressure, 101e3);
  law.pressure_exponent = resolver.pick_or(P::pressure_exponent, input.pressure_exponent, 0.5);
  law.liquefaction_1 = resolver.pick_or(P::liquefaction_1, input.liquefaction_1, 1.0);
  law.liquefaction_2 = resolver.pick_or(P::liquefaction_2, input.liquefaction_2, 0.0);
  law.atmospheric_pressure = resolver.pick_or(P::atmospheric_pressure, input.atmospheric_pressure, 101e3);
  law.zero_pressure_strength =
      resolver.pick_or(P::zero_pressure_strength, input.zero_pressure_strength, 1.73e3);
}

/// Strength and surfaces of a measured curve.
void resolve_curve(Resolver& resolver, const Pdmy03Input& input, Pdmy03& law) {
  if (input.friction || input.surfaces || input.peak_shear_strain) {
    throw std::invalid_argument("modulus_reduction already fixes friction, surfaces and peak_shear_strain; "
                                "leave them out");
  }
  law.friction = law.phase_transformation; // until the curve gives it
  check_values(law);
  build_surfaces(law, input.modulus_reduction);
  for (const P parameter : {P::friction, P::surfaces, P::peak_shear_strain})
    resolver.from(parameter, 0.0, Pdmy03Origin::curve);
  law.peak_shear_strain = std::sqrt(2.0 / 3.0) * input.modulus_reduction.back().shear_strain;
}

void resolve_hyperbola(Resolver& resolver, const Pdmy03Input& input, const Pdmy03Input& table, Pdmy03& law) {
  law.friction = resolver.pick(P::friction, input.friction, table.friction);
  check_values(law);
  build_surfaces(law, surface_count(resolver.pick_or(P::surfaces, input.surfaces, 20.0)));
}

} // namespace

Pdmy03Input pdmy03_recommended(double relative_density) {
  const RecommendedSet& set = recommended_set(relative_density);
  Pdmy03Input input;
  input.relative_density = set.relative_density;
  input.density = set.density;
  input.shear_modulus = set.shear_modulus;
  input.bulk_modulus = set.bulk_modulus;
  input.friction = set.friction;
  input.phase_transformation = set.phase_transformation;
  for (std::size_t k = 0; k < set.contraction.size(); ++k)
    input.contraction[k] = set.contraction[k];
  for (std::size_t k = 0; k < set.dilation.size(); ++k)
    input.dilation[k] = set.dilation[k];
  return input;
}

Pdmy03 pdmy03(const Pdmy03Input& input) {
  Pdmy03Input table;
  Pdmy03 law;
  if (input.relative_density) {
    table = pdmy03_recommended(*input.relative_density);
    law.relative_density = *table.relative_density;
  }
  law.cone = input.cone.value_or(Pdmy03Cone::triaxial_compression);
  law.cone_given = input.cone.has_value();
  Resolver resolver(law);
  resolve_soil(resolver, input, table, law);
  resolve_defaults(resolver, input, law);
  if (input.modulus_reduction.empty())
    resolve_hyperbola(resolver, input, table, law);
  else
    resolve_curve(resolver, input, law);
  validate(law);
  return law;
}

void validate(const Pdmy03& law) {
  check_values(law);
  if (law.surfaces < 3 || law.surfaces > most_pdmy03_surfaces)
    throw std::invalid_argument("a Pdmy03 is made by pdmy03(), which builds its surfaces");
}

} // namespace tremolo::materials
