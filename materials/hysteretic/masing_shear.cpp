#include "materials/hysteretic/masing_shear.hpp"

#include "materials/elastic/elastic_parameters.hpp"
#include "materials/law/parameter_check.hpp"

#include <fmt/format.h>

#include <string>

namespace tremolo::materials {
namespace {

/// Numbered names stay where they are, for the variables that view them.
struct Table {
  std::vector<std::string> names;
  std::vector<StateVariable> variables;

  Table() {
    names.reserve(masing_history_size);
    variables = {
        {"shear_strain", "1", "engineering shear strain since the initial state", 0.0},
        {"dynamic_shear_stress", "Pa", "shear stress since the initial state, by the Masing rules", 0.0},
        {"open_reversals", "1", "reversal points of loops that are still open", 0.0},
        {"merged_innermost", "1", "1 while the innermost reversal point stands for forgotten ones", 0.0,
         true},
        {"merged_loops", "1", "how often the innermost loops became one because the memory was full", 0.0}};
    for (std::size_t i = 0; i < masing_capacity; ++i) {
      names.push_back(fmt::format("reversal_{:02}_strain", i + 1));
      variables.push_back({names.back(), "1", "shear strain at a reversal", 0.0, true});
      names.push_back(fmt::format("reversal_{:02}_stress", i + 1));
      variables.push_back({names.back(), "Pa", "dynamic shear stress at a reversal", 0.0, true});
    }
  }
};

} // namespace

Traits traits(const MasingShear& /*law*/) {
  return {.name = "masing_shear",
          .response = Response::hysteretic,
          .three_dimensional = false,
          .total_stress = true};
}

std::span<const StateVariable> state_variables(const MasingShear& /*law*/) {
  static const Table table;
  return table.variables;
}

LinearElastic without_softening(const MasingShear& law) {
  return {law.elastic};
}

std::optional<Backbone> shear_backbone(const MasingShear& law) {
  return law.backbone();
}

void update(const MasingShear& law, const Points& points) {
  const Backbone backbone = law.backbone();
  const double lame = law.elastic.lame();
  const double shear = backbone.shear_modulus;
  for (std::size_t i = 0; i < points.count; ++i) {
    const double pressure = lame * (points.dexx[i] + points.deyy[i]);
    points.sxx[i] += pressure + 2.0 * shear * points.dexx[i];
    points.syy[i] += pressure + 2.0 * shear * points.deyy[i];
    points.szz[i] += pressure;

    const MutableMasingHistory history(points.state + i * masing_history_size, masing_history_size);
    const double before = accepted_stress(backbone, history);
    masing_commit(backbone, history, history[masing::strain] + points.dgxy[i]);
    const double change = accepted_stress(backbone, history) - before;
    points.plastic_work[i] += (points.sxy[i] + 0.5 * change) * (points.dgxy[i] - change / shear);
    points.sxy[i] += change;
  }
}

void validate(const MasingShear& law) {
  check(law.elastic);
  validate(law.backbone());
}

std::vector<ParameterValue> parameters(const MasingShear& law) {
  const auto given = backbone_parameters();
  std::vector<ParameterValue> values = elastic_parameters(law.elastic);
  values.push_back(report(given[0], law.reference_strain));
  if (law.shape) {
    values.push_back(report(given[3], law.backbone().strength()));
    const auto& [first, second, third, fourth, fifth] = *law.shape;
    values.push_back({"theta1", first, "1", "of the backbone, theta at zero strain", "given"});
    values.push_back({"theta2", second, "1", "of the backbone, change of theta to large strain", "given"});
    values.push_back({"theta3", third, "1", "of the backbone", "given"});
    values.push_back({"theta4", fourth, "1", "of the backbone", "given"});
    values.push_back({"theta5", fifth, "1", "of the backbone", "given"});
  } else {
    values.push_back(report(given[1], law.beta));
    values.push_back(report(given[2], law.exponent));
    values.push_back({"implied_strength", law.backbone().stress(0.1), "Pa",
                      "dynamic shear stress at 10 % strain", "backbone"});
  }
  append_loop_parameters(law.loops, values);
  return values;
}

} // namespace tremolo::materials
