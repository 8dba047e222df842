#include "materials/elastic/linear_elastic.hpp"

#include "materials/elastic/elastic_parameters.hpp"
#include "materials/elastic/elastic_trial.hpp"
#include "materials/law/parameter_check.hpp"

namespace tremolo::materials {

Traits traits(const LinearElastic& /*law*/) {
  return {.name = "linear_elastic"};
}

std::span<const StateVariable> state_variables(const LinearElastic& /*law*/) {
  return {};
}

void update(const LinearElastic& law, const Points& points) {
  elastic_trial(law.elastic, points, 0, points.count);
}

void validate(const LinearElastic& law) {
  check(law.elastic);
}

std::span<const LawField<LinearElastic>> fields(const LinearElastic& /*law*/) {
  return {};
}

std::vector<ParameterValue> parameters(const LinearElastic& law) {
  return elastic_parameters(law.elastic);
}

} // namespace tremolo::materials
