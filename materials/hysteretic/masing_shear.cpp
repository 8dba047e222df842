#include "materials/hysteretic/masing_shear.hpp"

#include "materials/elastic/elastic_parameters.hpp"
#include "materials/law/parameter_check.hpp"

namespace tremolo::materials {

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
    const double before = history[masing::stress];
    masing_commit(backbone, history, history[masing::strain] + points.dgxy[i]);
    const double change = history[masing::stress] - before;
    points.plastic_work[i] += (points.sxy[i] + 0.5 * change) * (points.dgxy[i] - change / shear);
    points.sxy[i] += change;
  }
}

void validate(const MasingShear& law) {
  check(law.elastic);
  validate(law.backbone());
}

std::vector<ParameterValue> parameters(const MasingShear& law) {
  std::vector<ParameterValue> values = elastic_parameters(law.elastic);
  values.push_back({"reference_strain", law.reference_strain, "1", "gamma_r of the backbone", "given"});
  values.push_back({"beta", law.beta, "1", "beta of the backbone", "given"});
  values.push_back({"exponent", law.exponent, "1", "s of the backbone; 1 is the hyperbola", "given"});
  return values;
}

} // namespace tremolo::materials
