#include "materials/law/law.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace tremolo::materials {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>; // clang 14 does not deduce it by itself

constexpr std::array plastic_strain_state = {StateVariable{
    "equivalent_plastic_strain", "1", "int sqrt(2/3 de:de) of the deviatoric plastic strain", 0.0}};

constexpr std::size_t most_names = masing_history_size + 3 * most_iwan_elements;

/// Numbered names need a place to stay.
using Names = std::vector<std::string>;

std::vector<StateVariable> masing_variables(Names& names) {
  std::vector<StateVariable> variables = {
      {"shear_strain", "1", "engineering shear strain since the initial state", 0.0},
      {"dynamic_shear_stress", "Pa", "shear stress since the initial state", 0.0},
      {"open_reversals", "1", "reversal points of loops that are still open", 0.0},
      {"merged_innermost", "1", "1 while the innermost reversal point stands for forgotten ones", 0.0, true},
      {"merged_loops", "1", "how often the innermost loops became one because the memory was full", 0.0}};
  for (std::size_t i = 0; i < masing_capacity; ++i) {
    names.push_back(fmt::format("reversal_{:02}_strain", i + 1));
    variables.push_back({names.back(), "1", "shear strain at a reversal", 0.0, true});
    names.push_back(fmt::format("reversal_{:02}_stress", i + 1));
    variables.push_back({names.back(), "Pa", "dynamic shear stress at a reversal", 0.0, true});
  }
  return variables;
}

std::vector<StateVariable> iwan_variables(Names& names) {
  std::vector<StateVariable> variables;
  for (std::size_t first = 1; first <= most_iwan_elements; first += iwan_group) {
    for (const char* component : {"xx", "yy", "xy"}) {
      for (std::size_t k = 0; k < iwan_group; ++k) {
        names.push_back(fmt::format("element_{:02}_s{}", first + k, component));
        variables.push_back({names.back(), "Pa", "deviatoric stress of an Iwan element", 0.0, true});
      }
    }
  }
  return variables;
}

/// Tables made once and never changed.
struct Tables {
  Names names;
  std::vector<StateVariable> masing;
  std::vector<StateVariable> iwan;
  Tables() {
    names.reserve(most_names); // the views stay valid
    masing = masing_variables(names);
    iwan = iwan_variables(names);
  }
};

const Tables& tables() {
  static const Tables made;
  return made;
}

} // namespace

std::string_view name(const Law& law) {
  using Name = std::string_view;
  return std::visit(Overloaded{[](const LinearElastic&) { return Name("linear_elastic"); },
                               [](const MohrCoulomb&) { return Name("mohr_coulomb"); },
                               [](const MasingShear&) { return Name("masing_shear"); },
                               [](const IwanShear&) { return Name("iwan_shear"); },
                               [](const DruckerPrager&) { return Name("drucker_prager"); },
                               [](const MultiYieldClay&) { return Name("multi_yield_clay"); },
                               [](const Pm4Sand&) { return Name("pm4sand"); },
                               [](const Pdmy03&) { return Name("pdmy03"); }},
                    law);
}

std::span<const StateVariable> state_variables(const Law& law) {
  using Variables = std::span<const StateVariable>;
  return std::visit(
      Overloaded{
          [](const LinearElastic&) { return Variables(); },
          [](const MohrCoulomb&) { return Variables(plastic_strain_state); },
          [](const MasingShear&) { return Variables(tables().masing); },
          [](const DruckerPrager&) { return Variables(plastic_strain_state); },
          [](const IwanShear& one) { return Variables(tables().iwan).first(3 * one.elements.size()); },
          [](const MultiYieldClay& one) { return Variables(tables().iwan).first(3 * one.elements.size()); },
          [](const Pm4Sand& one) { return state_variables(one); },
          [](const Pdmy03& one) { return state_variables(one); }},
      law);
}

void initialise(const Law& law, const Points& points) {
  const auto variables = state_variables(law);
  for (std::size_t i = 0; i < points.count; ++i) {
    for (const double stress : {points.sxx[i], points.syy[i], points.szz[i], points.sxy[i]}) {
      if (!std::isfinite(stress)) {
        throw std::invalid_argument(
            fmt::format("initial stress of point {}: {:g} Pa is not finite", i, stress));
      }
    }
    for (std::size_t k = 0; k < variables.size(); ++k) {
      points.state[i * variables.size() + k] = variables[k].initial;
    }
  }
  if (const auto* clay = std::get_if<MultiYieldClay>(&law)) {
    initialise(*clay, points);
  } else if (const auto* pm4 = std::get_if<Pm4Sand>(&law)) {
    initialise(*pm4, points);
  } else if (const auto* pdmy = std::get_if<Pdmy03>(&law)) {
    initialise(*pdmy, points);
  }
}

void update(const Law& law, const Points& points) {
  std::visit([&](const auto& one) { update(one, points); }, law);
}

const Elasticity& elasticity(const Law& law) {
  return std::visit([](const auto& one) -> const Elasticity& { return one.elastic; }, law);
}

Law with_rest_coefficient(Law law, double coefficient) {
  std::visit([coefficient](auto& one) { one.elastic.at_rest = coefficient; }, law);
  return law;
}

double p_wave_speed_bound(const Law& law, const Points& points) {
  if (const auto* pm4 = std::get_if<Pm4Sand>(&law)) {
    return p_wave_speed_bound(*pm4, points);
  }
  if (const auto* pdmy = std::get_if<Pdmy03>(&law)) {
    return p_wave_speed_bound(*pdmy, points);
  }
  return elasticity(law).p_wave_speed();
}

bool three_dimensional(const Law& law) {
  return !std::holds_alternative<MasingShear>(law) && !std::holds_alternative<Pm4Sand>(law);
}

std::vector<ParameterValue> parameters(const Law& law) {
  return std::visit([](const auto& one) { return parameters(one); }, law);
}

Law without_softening(const Law& law) {
  return std::visit(Overloaded{[](const LinearElastic& one) -> Law { return one; },
                               [](const MohrCoulomb& one) -> Law { return without_softening(one); },
                               [](const MasingShear& one) -> Law { return LinearElastic{one.elastic}; },
                               [](const IwanShear& one) -> Law { return LinearElastic{one.elastic}; },
                               [](const DruckerPrager& one) -> Law { return one; },
                               [](const MultiYieldClay& one) -> Law { return LinearElastic{one.elastic}; },
                               [](const Pm4Sand& one) -> Law { return LinearElastic{one.elastic}; },
                               [](const Pdmy03& one) -> Law { return LinearElastic{one.elastic}; }},
                    law);
}

Law after_shaking(const Law& law) {
  if (const auto* pm4 = std::get_if<Pm4Sand>(&law)) {
    return after_shaking(*pm4);
  }
  return law;
}

void validate(const Law& law) {
  std::visit([](const auto& one) { validate(one); }, law);
}

} // namespace tremolo::materials
