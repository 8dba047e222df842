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
  Resolver(Pdmy03Input input, Pdmy03Input table, Pdmy03& law)
      : input_(std::move(input)), table_(std::move(table)), law_(law) {}

  /// A value that is given, or stands in the recommended set.
  double pick(P parameter) {
    const Pdmy03Row& one = row(parameter);
    if (const auto given = one.input(input_))
      return from(parameter, *given, Pdmy03Origin::given);
    if (const auto in_set = one.input(table_))
      return from(parameter, *in_set, Pdmy03Origin::table);
    throw std::invalid_argument(fmt::format(
        "{} is missing: give it, or a relative_density of 0.33, 0.57, 0.74 or 0.87", one.text.name));
  }

  /// A value that is given, or the default.
  double pick_or_default(P parameter) {
    const Pdmy03Row& one = row(parameter);
    const auto given = one.input(input_);
    return given ? from(parameter, *given, Pdmy03Origin::given)
                 : from(parameter, one.fallback, Pdmy03Origin::fallback);
  }

  double from(P parameter, double value, Pdmy03Origin origin) {
    law_.origins[static_cast<std::size_t>(parameter)] = origin;
    return value;
  }

private:
  Pdmy03Input input_;
  Pdmy03Input table_;
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
  check(law.elastic);
  check_angles(law);
  for (const Pdmy03Row& one : pdmy03_rows())
    if (&one != &row(P::friction) && &one != &row(P::phase_transformation) && &one != &row(P::surfaces))
      check(one.text, one.value(law));
  check_at_most(row(P::zero_pressure_strength).text, law.zero_pressure_strength,
                row(P::reference_pressure).text, law.reference_pressure);
}

std::size_t surface_count(double given) {
  check(row(P::surfaces).text, given);
  if (given != std::floor(given))
    throw std::invalid_argument(fmt::format("surfaces = {:g} must be a whole number", given));
  return static_cast<std::size_t>(given);
}

void resolve_soil(Resolver& resolver, Pdmy03& law) {
  const double shear = resolver.pick(P::shear_modulus);
  const double bulk = resolver.pick(P::bulk_modulus);
  check(row(P::shear_modulus).text, shear);
  check(row(P::bulk_modulus).text, bulk);
  law.elastic = elasticity_of(resolver.pick(P::density), shear, bulk);
  law.phase_transformation = resolver.pick(P::phase_transformation);
  for (std::size_t k = 0; k < law.contraction.size(); ++k)
    law.contraction[k] = resolver.pick(following(P::contraction_a, k));
  for (std::size_t k = 0; k < law.dilation.size(); ++k)
    law.dilation[k] = resolver.pick(following(P::dilation_a, k));
}

void resolve_defaults(Resolver& resolver, Pdmy03& law) {
  law.peak_shear_strain = resolver.pick_or_default(P::peak_shear_strain);
  law.reference_pressure = resolver.pick_or_default(P::reference_pressure);
  law.pressure_exponent = resolver.pick_or_default(P::pressure_exponent);
  law.liquefaction_1 = resolver.pick_or_default(P::liquefaction_1);
  law.liquefaction_2 = resolver.pick_or_default(P::liquefaction_2);
  law.atmospheric_pressure = resolver.pick_or_default(P::atmospheric_pressure);
  law.zero_pressure_strength = resolver.pick_or_default(P::zero_pressure_strength);
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

void resolve_hyperbola(Resolver& resolver, Pdmy03& law) {
  law.friction = resolver.pick(P::friction);
  check_values(law);
  build_surfaces(law, surface_count(resolver.pick_or_default(P::surfaces)));
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
  Resolver resolver(input, table, law);
  resolve_soil(resolver, law);
  resolve_defaults(resolver, law);
  if (input.modulus_reduction.empty())
    resolve_hyperbola(resolver, law);
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
