// Parameters of PM4Sand: one table says of each its unit, meaning, default and range (Boulanger & Ziotopoulou
// 2017, table 2; break points of c_eps as in the reference curves' producer, which match the authors' own
// program).

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

/// A parameter that may be left out.
struct Optional {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  std::optional<double> Pm4SandInput::*input;
  double& (*value)(Pm4Sand&);
  double (*fallback)(const Pm4Sand&); ///< may use what stands above it in the table
  std::string_view rule;
  double low;
  double high;
};

double default_c_eps(const Pm4Sand& law) {
  return std::clamp(0.5 - 1.5 * (law.relative_density - 0.55), 0.2, 0.5);
}

double default_C_kaf(const Pm4Sand& law) {
  const double above = law.relative_density - 0.26;
  return std::clamp(5.0 + 220.0 * above * above * above, 4.0, 35.0);
}

using Input = Pm4SandInput;
using Law = Pm4Sand;

const std::array optional_parameters = {
    Optional{"p_A", "Pa", "atmospheric pressure", &Input::p_A, [](Law& l) -> double& { return l.p_A; },
             [](const Law&) { return 101.3e3; }, "101.3 kPa", 1.0, 1e9},
    Optional{"e_max", "1", "void ratio at D_R = 0", &Input::e_max, [](Law& l) -> double& { return l.e_max; },
             [](const Law&) { return 0.8; }, "0.8", 0.01, 10.0},
    Optional{"e_min", "1", "void ratio at D_R = 1", &Input::e_min, [](Law& l) -> double& { return l.e_min; },
             [](const Law&) { return 0.5; }, "0.5", 0.0, 10.0},
    Optional{"n_b", "1", "bounding surface against state", &Input::n_b,
             [](Law& l) -> double& { return l.n_b; }, [](const Law&) { return 0.5; }, "0.5", 0.0, 10.0},
    Optional{"n_d", "1", "dilatancy surface against state", &Input::n_d,
             [](Law& l) -> double& { return l.n_d; }, [](const Law&) { return 0.1; }, "0.1", 0.0, 10.0},
    Optional{"phi_cv", "rad", "friction angle at the critical state", &Input::phi_cv,
             [](Law& l) -> double& { return l.phi_cv; }, [](const Law&) { return 33.0 * degree; },
             "33 degrees", 1.0 * degree, 60.0 * degree},
    Optional{"poisson", "1", "Poisson's ratio", &Input::poisson,
             [](Law& l) -> double& { return l.elastic.poisson; }, [](const Law&) { return 0.3; }, "0.3", 0.0,
             0.4999},
    Optional{"Q", "1", "critical state line, crushing", &Input::Q, [](Law& l) -> double& { return l.Q; },
             [](const Law&) { return 10.0; }, "10", 5.0, 20.0},
    Optional{"R", "1", "critical state line", &Input::R, [](Law& l) -> double& { return l.R; },
             [](const Law&) { return 1.5; }, "1.5", 0.01, 10.0},
    Optional{"m", "1", "size of the yield surface", &Input::m, [](Law& l) -> double& { return l.m; },
             [](const Law&) { return 0.01; }, "0.01", 1e-4, 0.1},
    Optional{"h_o", "1", "plastic modulus against elastic", &Input::h_o,
             [](Law& l) -> double& { return l.h_o; },
             [](const Law& l) { return std::max(0.3, 0.5 * (0.25 + l.relative_density)); },
             "max(0.3, (0.25 + D_R)/2)", 1e-3, 100.0},
    Optional{"c_z", "1", "rate of fabric", &Input::c_z, [](Law& l) -> double& { return l.c_z; },
             [](const Law&) { return 250.0; }, "250", 0.0, 1e4},
    Optional{"c_eps", "1", "rate of strain accumulation in liquefied sand", &Input::c_eps,
             [](Law& l) -> double& { return l.c_eps; }, default_c_eps, "0.5 - 1.5 (D_R - 0.55) in [0.2, 0.5]",
             0.0, 100.0},
    Optional{"C_GD", "1", "degradation of G with cumulated fabric", &Input::C_GD,
             [](Law& l) -> double& { return l.C_GD; }, [](const Law&) { return 2.0; }, "2", 1.0, 100.0},
    Optional{"C_DR", "1", "rotated dilatancy surface", &Input::C_DR, [](Law& l) -> double& { return l.C_DR; },
             [](const Law& l) { return std::clamp(5.0 + 25.0 * (l.relative_density - 0.35), 1.0, 10.0); },
             "5 + 25 (D_R - 0.35) in [1, 10]", 0.1, 10.0},
    Optional{"C_kaf", "1", "plastic modulus under static shear stress", &Input::C_kaf,
             [](Law& l) -> double& { return l.C_kaf; }, default_C_kaf, "5 + 220 (D_R - 0.26)^3 in [4, 35]",
             4.0, 35.0},
    Optional{"F_sed_min", "1", "smallest reduction of stiffness after shaking", &Input::F_sed_min,
             [](Law& l) -> double& { return l.F_sed_min; },
             [](const Law& l) { return std::min(0.03 * std::exp(2.6 * l.relative_density), 0.99); },
             "min(0.03 exp(2.6 D_R), 0.99)", 1e-4, 1.0},
    Optional{"p_sedo", "Pa", "pressure scale of that reduction", &Input::p_sedo,
             [](Law& l) -> double& { return l.p_sedo; }, [](const Law& l) { return l.p_A / 5.0; }, "p_A/5",
             0.0, 1e9},
};

/// The value in force; the accessors are those that also write.
double value_of(const Optional& parameter, Pm4Sand law) {
  return parameter.value(law);
}

/// A value that initialise() makes from the stress, shown for an isotropic p_0 = p_A.
ParameterValue from_stress(std::string_view parameter, const std::optional<double>& given, double at_p_A,
                           std::string_view meaning, std::string_view rule) {
  const std::string origin =
      given ? "given"
            : fmt::format("default: state variable from the initial stress, {}; here at p_0 = p_A", rule);
  return {parameter, given.value_or(at_p_A), "1", meaning, origin};
}

} // namespace

Pm4Sand pm4sand(const Pm4SandInput& input) {
  check_positive("density", input.density);
  check_range("relative_density", input.relative_density, 0.05, 1.2);
  check_positive("G_o", input.G_o);
  Pm4Sand law;
  law.relative_density = input.relative_density;
  law.G_o = input.G_o;
  law.h_po = input.h_po;
  for (std::size_t k = 0; k < optional_parameters.size(); ++k) {
    const Optional& parameter = optional_parameters[k];
    const std::optional<double>& given = input.*parameter.input;
    law.given[k] = given.has_value();
    parameter.value(law) = given ? *given : parameter.fallback(law);
  }
  law.A_do = input.A_do;
  law.z_max = input.z_max;
  law.post_shake = input.post_shake;
  const double nu = law.elastic.poisson;
  law.M = 2.0 * std::sin(law.phi_cv);
  law.bulk_ratio = 2.0 * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu));
  const double void_range = law.e_max - law.e_min;
  law.density_rate = (1.0 + law.e_max - law.relative_density * void_range) / void_range;
  law.elastic = {input.density, 2.0 * (1.0 + nu) * law.G_o * law.p_A, nu};
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
  std::vector<ParameterValue> list = {
      {"density", law.elastic.density, "kg/m3", "mass density", "given"},
      {"relative_density", law.relative_density, "1", "D_R, apparent", "given"},
      {"G_o", law.G_o, "1", "shear modulus coefficient: G = G_o p_A sqrt(p/p_A)", "given"},
      {"h_po", law.h_po, "1", "contraction rate, fitted to the cyclic strength", "given"}};
  for (std::size_t k = 0; k < optional_parameters.size(); ++k) {
    const Optional& parameter = optional_parameters[k];
    const std::string origin = law.given[k] ? "given" : fmt::format("default: {}", parameter.rule);
    list.push_back({parameter.name, value_of(parameter, law), parameter.unit, parameter.meaning, origin});
  }
  const pm4::Initial at_p_A = pm4::initial_state(law, {law.p_A, {}}).start;
  list.push_back(from_stress("A_do", law.A_do, at_p_A.A_do, "dilatancy",
                             "2.5 (asin(M_b/2) - asin(M/2))/(M_b - M_d), 1.24 if loose of critical"));
  list.push_back(
      from_stress("z_max", law.z_max, at_p_A.z_max, "largest fabric", "min(0.7 exp(-6.1 xi_R0), 20)"));
  list.push_back({"post_shake", law.post_shake ? 1.0 : 0.0, "1", "1: reduced stiffness after shaking",
                  law.post_shake ? "given" : "default: 0"});
  return list;
}

void validate(const Pm4Sand& law) {
  check(law.elastic);
  check_range("relative_density", law.relative_density, 0.05, 1.2);
  check_positive("G_o", law.G_o);
  check_range("h_po", law.h_po, 1e-6, 1e6);
  for (const Optional& parameter : optional_parameters)
    check_range(parameter.name, value_of(parameter, law), parameter.low, parameter.high);
  if (!(law.e_min < law.e_max))
    throw std::invalid_argument(fmt::format("e_min = {:g} must be below e_max = {:g}", law.e_min, law.e_max));
  if (law.A_do)
    check_range("A_do", *law.A_do, 0.0, 100.0);
  if (law.z_max)
    check_range("z_max", *law.z_max, 1e-3, 1e3);
  check_range("integration.largest_strain", law.integration.largest_strain, 1e-8, 0.01);
  check_range("integration.smallest_strain", law.integration.smallest_strain, 1e-12, 0.01);
  check_range("integration.tolerance", law.integration.tolerance, 1e-12, 1.0);
}

} // namespace tremolo::materials
