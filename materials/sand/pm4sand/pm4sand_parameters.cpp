// Parameters of PM4Sand (Boulanger & Ziotopoulou 2017, table 2; break points of c_eps as in the reference
// curves' producer, which match the authors' own program). One table holds each parameter's name, unit,
// meaning, range and default; what is left out may follow from what stands above it.

#include "materials/elastic/elastic_parameters.hpp"
#include "materials/law/parameter_check.hpp"
#include "materials/sand/pm4sand/pm4sand.hpp"
#include "materials/sand/pm4sand/pm4sand_initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

namespace tremolo::materials {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

using Input = Pm4SandInput;
using Law = Pm4Sand;

/// A parameter that initialise() makes from the stress where it is not given.
struct FromStress {
  std::optional<double> Law::*given = nullptr;
  double pm4::Initial::*start = nullptr;
};

struct Row {
  Parameter text;
  std::optional<double>& (*input)(Input&);
  double& (*value)(Law&);         ///< nullptr: it is one of those from the stress
  double (*fallback)(const Law&); ///< nullptr: there is none
  FromStress from_stress = {};
};

template <auto Member>
constexpr auto& of(auto& from) {
  return from.*Member;
}

/// A parameter with the name of its value in the input and in the law.
template <auto InInput, auto InLaw>
constexpr Row row(const Parameter& text, double (*fallback)(const Law&) = nullptr) {
  return {text, &of<InInput, Input>, &of<InLaw, Law>, fallback};
}

template <auto InInput, auto InLaw, auto AtStart>
constexpr Row of_stress(const Parameter& text) {
  return {text, &of<InInput, Input>, nullptr, nullptr, {InLaw, AtStart}};
}

template <int Numerator, int Denominator = 1>
double constant(const Law& /*law*/) {
  return static_cast<double>(Numerator) / Denominator;
}

double default_c_eps(const Law& law) {
  return std::clamp(0.5 - 1.5 * (law.relative_density - 0.55), 0.2, 0.5);
}

double default_C_kaf(const Law& law) {
  const double above = law.relative_density - 0.26;
  return std::clamp(5.0 + 220.0 * above * above * above, 4.0, 35.0);
}

constexpr Range coefficient = {.low = 0.0, .high = 10.0};

const std::array rows = {
    Row{elastic_constants[0], &of<&Input::density, Input>,
        [](Law& l) -> double& { return l.elastic.density; }, nullptr},
    row<&Input::relative_density, &Law::relative_density>(
        {.name = "relative_density",
         .unit = "1",
         .meaning = "apparent relative density D_R, a fraction",
         .range = {.low = 0.05, .high = 1.2}}),
    row<&Input::p_A, &Law::p_A>({.name = "atmospheric_pressure",
                                 .unit = "Pa",
                                 .meaning = "atmospheric pressure p_A of the formulas",
                                 .range = {.low = 1.0, .high = 1e9},
                                 .otherwise = "101.3e3"},
                                constant<101300>),
    row<&Input::G_o, &Law::G_o>({.name = "shear_modulus_coefficient",
                                 .unit = "1",
                                 .meaning = "coefficient G_o of G = G_o p_A sqrt(p/p_A)",
                                 .range = above_zero,
                                 .remark = "167 sqrt(46 D_R^2 + 2.5) where nothing is measured."}),
    row<&Input::h_po, &Law::h_po>({.name = "contraction_rate",
                                   .unit = "1",
                                   .meaning = "contraction rate h_po, fitted last, to the cyclic strength",
                                   .range = {.low = 1e-6, .high = 1e6},
                                   .remark = "`tremolo calibrate` fits it. Larger is stronger."}),
    row<&Input::e_max, &Law::e_max>({.name = "e_max",
                                     .unit = "1",
                                     .meaning = "largest void ratio, at D_R = 0",
                                     .range = {.low = 0.01, .high = 10.0},
                                     .otherwise = "0.8"},
                                    constant<8, 10>),
    row<&Input::e_min, &Law::e_min>({.name = "e_min",
                                     .unit = "1",
                                     .meaning = "smallest void ratio, at D_R = 1",
                                     .range = coefficient,
                                     .otherwise = "0.5"},
                                    constant<1, 2>),
    row<&Input::n_b, &Law::n_b>({.name = "n_b",
                                 .unit = "1",
                                 .meaning = "bounding surface M_b = M exp(-n_b xi_R)",
                                 .range = coefficient,
                                 .otherwise = "0.5"},
                                constant<1, 2>),
    row<&Input::n_d, &Law::n_d>({.name = "n_d",
                                 .unit = "1",
                                 .meaning = "dilatancy surface M_d = M exp(n_d xi_R)",
                                 .range = coefficient,
                                 .otherwise = "0.1"},
                                constant<1, 10>),
    row<&Input::phi_cv, &Law::phi_cv>({.name = "phi_cv_deg",
                                       .unit = "degrees",
                                       .meaning = "friction angle at the critical state",
                                       .range = {.low = 1.0, .high = 60.0},
                                       .otherwise = "33"},
                                      [](const Law&) { return 33.0 * degree; }),
    Row{{.name = "poisson",
         .unit = "1",
         .meaning = elastic_constants[2].meaning,
         .range = {.low = 0.0, .high = 0.4999},
         .otherwise = "0.3"},
        &of<&Input::poisson, Input>,
        [](Law& l) -> double& { return l.elastic.poisson; },
        constant<3, 10>},
    row<&Input::Q, &Law::Q>({.name = "Q",
                             .unit = "1",
                             .meaning = "Q of Bolton's critical state line, crushing",
                             .range = {.low = 5.0, .high = 20.0},
                             .otherwise = "10"},
                            constant<10>),
    row<&Input::R, &Law::R>({.name = "R",
                             .unit = "1",
                             .meaning = "R of Bolton's critical state line",
                             .range = {.low = 0.01, .high = 10.0},
                             .otherwise = "1.5"},
                            constant<3, 2>),
    row<&Input::m, &Law::m>({.name = "m",
                             .unit = "1",
                             .meaning = "size of the yield surface",
                             .range = {.low = 1e-4, .high = 0.1},
                             .otherwise = "0.01"},
                            constant<1, 100>),
    row<&Input::h_o, &Law::h_o>(
        {.name = "h_o",
         .unit = "1",
         .meaning = "plastic modulus against elastic",
         .range = {.low = 1e-3, .high = 100.0},
         .otherwise = "max(0.3, (0.25 + D_R)/2)"},
        [](const Law& l) { return std::max(0.3, 0.5 * (0.25 + l.relative_density)); }),
    of_stress<&Input::A_do, &Law::A_do, &pm4::Initial::A_do>(
        {.name = "A_do",
         .unit = "1",
         .meaning = "dilatancy",
         .range = {.low = 0.0, .high = 100.0},
         .otherwise = "from the initial stress, 2.5 (asin(M_b/2) - asin(M/2))/(M_b - M_d), 1.24 if "
                      "loose of critical"}),
    of_stress<&Input::z_max, &Law::z_max, &pm4::Initial::z_max>(
        {.name = "z_max",
         .unit = "1",
         .meaning = "largest fabric",
         .range = {.low = 1e-3, .high = 1e3},
         .otherwise = "from the initial stress, min(0.7 exp(-6.1 xi_R0), 20)"}),
    row<&Input::c_z, &Law::c_z>({.name = "c_z",
                                 .unit = "1",
                                 .meaning = "rate of fabric",
                                 .range = {.low = 0.0, .high = 1e4},
                                 .otherwise = "250"},
                                constant<250>),
    row<&Input::c_eps, &Law::c_eps>({.name = "c_eps",
                                     .unit = "1",
                                     .meaning = "rate of strain accumulation in liquefied sand",
                                     .range = {.low = 0.0, .high = 100.0},
                                     .otherwise = "0.5 - 1.5 (D_R - 0.55) in [0.2, 0.5]"},
                                    default_c_eps),
    row<&Input::C_GD, &Law::C_GD>({.name = "C_GD",
                                   .unit = "1",
                                   .meaning = "degradation of G with cumulated fabric",
                                   .range = {.low = 1.0, .high = 100.0},
                                   .otherwise = "2"},
                                  constant<2>),
    row<&Input::C_DR, &Law::C_DR>(
        {.name = "C_DR",
         .unit = "1",
         .meaning = "rotated dilatancy surface",
         .range = {.low = 0.1, .high = 10.0},
         .otherwise = "5 + 25 (D_R - 0.35) in [1, 10]"},
        [](const Law& l) { return std::clamp(5.0 + 25.0 * (l.relative_density - 0.35), 1.0, 10.0); }),
    row<&Input::C_kaf, &Law::C_kaf>({.name = "C_kaf",
                                     .unit = "1",
                                     .meaning = "plastic modulus under static shear stress",
                                     .range = {.low = 4.0, .high = 35.0},
                                     .otherwise = "5 + 220 (D_R - 0.26)^3 in [4, 35]"},
                                    default_C_kaf),
    row<&Input::F_sed_min, &Law::F_sed_min>(
        {.name = "F_sed_min",
         .unit = "1",
         .meaning = "smallest reduction of stiffness in reconsolidation after shaking",
         .range = {.low = 1e-4, .high = 1.0},
         .otherwise = "min(0.03 exp(2.6 D_R), 0.99)"},
        [](const Law& l) { return std::min(0.03 * std::exp(2.6 * l.relative_density), 0.99); }),
    row<&Input::p_sedo, &Law::p_sedo>({.name = "p_sedo",
                                       .unit = "Pa",
                                       .meaning = "pressure scale of that reduction",
                                       .range = {.low = 0.0, .high = 1e9},
                                       .otherwise = "`atmospheric_pressure`/5"},
                                      [](const Law& l) { return l.p_A / 5.0; }),
    Row{{.name = "tolerance",
         .unit = "1",
         .meaning =
             "relative error of a sub-step of the law's integration, in stress, back stress and fabric",
         .range = {.low = 1e-8, .high = 1e-2},
         .otherwise = "1e-4",
         .remark = "1e-3 saves a third of the law's time (docs/materials/pm4sand.md)."},
        &of<&Input::tolerance, Input>,
        [](Law& l) -> double& { return l.integration.tolerance; },
        constant<1, 10000>},
};

/// The value in force; the accessors are those that also write.
double value_of(const Row& one, Law law) {
  return one.value(law);
}

} // namespace

std::span<const InputField<Pm4SandInput>> pm4sand_parameters() {
  static const std::vector<InputField<Input>> all = [] {
    std::vector<InputField<Input>> list;
    for (const Row& one : rows)
      list.push_back({one.text, one.input});
    return list;
  }();
  return all;
}

Pm4Sand pm4sand(const Pm4SandInput& given) {
  Input input = given;
  Law law;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto& [text, member, value, fallback, from_stress] = rows[k];
    const std::optional<double>& number = member(input);
    law.given[k] = number.has_value();
    if (!number && text.needed())
      throw std::invalid_argument(fmt::format("{} is missing", text.name));
    if (value != nullptr)
      value(law) = number ? *number : fallback(law);
    else
      law.*from_stress.given = number;
  }
  law.post_shake = input.post_shake;
  const double nu = law.elastic.poisson;
  law.M = 2.0 * std::sin(law.phi_cv);
  law.bulk_ratio = 2.0 * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu));
  const double void_range = law.e_max - law.e_min;
  law.density_rate = (1.0 + law.e_max - law.relative_density * void_range) / void_range;
  law.elastic.young = 2.0 * (1.0 + nu) * law.G_o * law.p_A;
  validate(law);
  return law;
}

Pm4Sand after_shaking(Pm4Sand law) {
  law.post_shake = true;
  return law;
}

Pm4Sand shaken_again(Pm4Sand law) {
  law.post_shake = false;
  return law;
}

std::optional<double> relative_density(const Pm4Sand& law) {
  return law.relative_density;
}

std::optional<double> contraction_rate(const Pm4Sand& law) {
  return law.h_po;
}

Pm4Sand with_contraction_rate(Pm4Sand law, double rate) {
  law.h_po = rate;
  return law;
}

std::vector<ParameterValue> parameters(const Pm4Sand& law) {
  std::vector<ParameterValue> list;
  const pm4::Initial at_p_A = pm4::initial_state(law, {law.p_A, {}}).start;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Row& one = rows[k];
    const std::string origin = law.given[k] ? "given" : fmt::format("default: {}", one.text.otherwise);
    if (one.value != nullptr)
      list.push_back(report(one.text, value_of(one, law), origin));
    else if (const auto& given = law.*one.from_stress.given)
      list.push_back(report(one.text, *given));
    else // shown for an isotropic p_0 = p_A
      list.push_back(report(one.text, at_p_A.*one.from_stress.start, origin + "; here at p_0 = p_A"));
  }
  list.push_back({"post_shake", law.post_shake ? 1.0 : 0.0, "1", "1: reduced stiffness after shaking",
                  law.post_shake ? "given" : "default: 0"});
  return list;
}

void validate(const Pm4Sand& law) {
  for (const Row& one : rows)
    if (one.value != nullptr)
      check(one.text, value_of(one, law));
    else if (const auto& given = law.*one.from_stress.given)
      check(one.text, *given);
  check(law.elastic);
  if (!(law.e_min < law.e_max))
    throw std::invalid_argument(fmt::format("e_min = {:g} must be below e_max = {:g}", law.e_min, law.e_max));
  check_range("integration.largest_strain", law.integration.largest_strain, 1e-8, 0.01);
  check_range("integration.smallest_strain", law.integration.smallest_strain, 1e-12, 0.01);
}

} // namespace tremolo::materials
