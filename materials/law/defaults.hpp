#pragma once

// Defaults for laws. A law is a struct of parameters with a member `elastic`; what it does are functions
// beside it, in its own header. Each law must have
//
//     Traits traits(const X&);
//     std::span<const StateVariable> state_variables(const X&);
//     void update(const X&, const Points&);
//     void validate(const X&);
//     std::vector<ParameterValue> parameters(const X&);
//
// and, where files give it by plain numbers, which then need no reader of their own,
//
//     std::span<const LawField<X>> fields(const X&);
//
// and it overloads those functions below that it knows better. law.cpp calls them as one calls swap: the
// law's own overload goes before the template here.

#include "materials/hysteretic/backbone/backbone.hpp"
#include "materials/law/points.hpp"
#include "materials/law/strength_line.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::materials::defaults {

/// The state block holds the initial values of the state table, and the stress is unchanged.
template <class L>
void initialise(const L& /*law*/, const Points& /*points*/) {}

template <class L>
double p_wave_speed_bound(const L& law, const Points& /*points*/) {
  return law.elastic.p_wave_speed();
}

template <class L>
void stiffness_ratios(const L& /*law*/, const Points& points, double* ratios) {
  std::fill_n(ratios, points.count, 1.0);
}

template <class L>
void update_and_find_stiffness(const L& law, const Points& points, double* ratios) {
  stiffness_ratios(law, points, ratios);
  update(law, points);
}

template <class L>
const L& without_softening(const L& law) {
  return law;
}

template <class L>
std::optional<L> with_reduced_strength(const L& /*law*/, double /*factor*/) {
  return std::nullopt;
}

template <class L>
const L& after_shaking(const L& law) {
  return law;
}

template <class L>
const L& shaken_again(const L& law) {
  return law;
}

template <class L>
const L& for_cell_size(const L& law, double /*cell_size*/, double /*reference_size*/) {
  return law;
}

template <class L>
std::optional<Backbone> shear_backbone(const L& /*law*/) {
  return std::nullopt;
}

template <class L>
std::optional<double> relative_density(const L& /*law*/) {
  return std::nullopt;
}

template <class L>
std::optional<double> contraction_rate(const L& /*law*/) {
  return std::nullopt;
}

template <class L>
L with_contraction_rate(const L& law, double /*rate*/) {
  throw std::invalid_argument(std::string(traits(law).name) + " has no contraction rate");
}

template <class L>
std::vector<StrengthLine> strength_lines(const L& /*law*/) {
  return {};
}

template <class L>
std::vector<std::string> notes(const L& /*law*/) {
  return {};
}

} // namespace tremolo::materials::defaults
