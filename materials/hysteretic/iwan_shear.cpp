#include "materials/hysteretic/iwan_shear.hpp"

#include "materials/elastic/elastic_parameters.hpp"
#include "materials/hysteretic/backbone/backbone_polygon.hpp"
#include "materials/law/parameter_check.hpp"

#include <span>

namespace tremolo::materials {
namespace {

void check(const IwanFit& fit) {
  check_element_count(fit.elements);
  check_range("largest_strain", fit.largest_strain, 1e-6, 10.0);
}

} // namespace

IwanShear iwan_shear(const Elasticity& elastic, const Backbone& backbone, const IwanFit& fit) {
  check(elastic);
  check(fit);
  validate(backbone);
  return {elastic, parallel_elements(polygon(backbone, fit.elements, fit.largest_strain)), backbone.loops};
}

IwanShear iwan_shear(const Elasticity& elastic, double reference_strain, double beta, double exponent,
                     const IwanFit& fit) {
  check(elastic);
  return iwan_shear(elastic, Backbone{elastic.shear_modulus(), reference_strain, beta, exponent}, fit);
}

double monotonic_stress(const IwanShear& law, double strain) {
  return monotonic_stress(std::span(law.elements), strain);
}

Traits traits(const IwanShear& /*law*/) {
  return {.name = "iwan_shear", .response = Response::hysteretic, .total_stress = true};
}

std::span<const StateVariable> state_variables(const IwanShear& law) {
  return iwan_state_variables(law.elements.size(), law.loops);
}

LinearElastic without_softening(const IwanShear& law) {
  return {law.elastic};
}

std::optional<DruckerPrager> with_reduced_strength(const IwanShear& law, double factor) {
  if (!law.strength)
    return std::nullopt;
  return frictionless(law.elastic, *law.strength / factor);
}

void update(const IwanShear& law, const Points& points) {
  update(law.elastic, law.elements, law.loops, points);
}

void validate(const IwanShear& law) {
  validate(law.elastic, law.elements);
  validate(law.loops);
}

std::vector<ParameterValue> parameters(const IwanShear& law) {
  std::vector<ParameterValue> values = elastic_parameters(law.elastic);
  const double last_yield = law.elements.back().strength / law.elements.back().shear_modulus;
  values.push_back({"elements", static_cast<double>(law.elements.size()), "1",
                    "parallel elastoplastic elements", "given"});
  values.push_back(
      {"largest_strain", last_yield, "1", "shear strain beyond which the stress is level", "given"});
  values.push_back(report(find(backbone_parameters(), "shear_strength"), monotonic_stress(law, last_yield),
                          "backbone at largest_strain"));
  append_loop_parameters(law.loops, values);
  return values;
}

} // namespace tremolo::materials
