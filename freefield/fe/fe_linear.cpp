#include "freefield/fe/fe_linear.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::freefield {
namespace {

using Modulus = double (materials::Elasticity::*)() const;
constexpr Modulus shear = &materials::Elasticity::shear_modulus;
constexpr Modulus dilation = &materials::Elasticity::p_modulus;

std::vector<ScalarElement> elements(const Profile& profile, const ColumnMesh& mesh, const Damping& damping,
                                    Modulus modulus) {
  std::vector<ScalarElement> elements;
  elements.reserve(mesh.elements());
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    const Layer& layer = profile.layers[mesh.element_layer[e]];
    const DampingCoefficients c = coefficients(damping, layer.damping_ratio);
    elements.push_back({mesh.length(e), layer.soil.density, (layer.soil.*modulus)(), c.alpha, c.beta});
  }
  return elements;
}

ScalarSettings scalar_settings(const Profile& profile, const FeColumnSettings& settings, Modulus modulus) {
  return {.base = settings.base,
          .base_impedance = std::sqrt(profile.half_space.density * (profile.half_space.*modulus)()),
          .time_step = settings.time_step,
          .integrator = settings.integrator,
          .hht_alpha = settings.hht_alpha};
}

} // namespace

double central_difference_limit(const Profile& profile, const ColumnMesh& mesh, const Damping& damping) {
  return std::min(central_difference_limit(elements(profile, mesh, damping, shear)),
                  central_difference_limit(elements(profile, mesh, damping, dilation)));
}

LinearColumn::LinearColumn(const Profile& profile, const ColumnMesh& mesh, const FeColumnSettings& settings)
    : mesh_(mesh), base_kind_(settings.base), rise_(rise_to_damped_soil(profile)), dt_(settings.time_step),
      shear_(elements(profile, mesh, settings.damping, shear), scalar_settings(profile, settings, shear)),
      dilation_(elements(profile, mesh, settings.damping, dilation),
                scalar_settings(profile, settings, dilation)) {
  lateral_ratio_.reserve(mesh.elements());
  for (const std::size_t layer : mesh.element_layer)
    lateral_ratio_.push_back(profile.layers[layer].soil.lame() / profile.layers[layer].soil.p_modulus());
}

void LinearColumn::step(const InputVelocity& input, double time) {
  base_ = advanced(base_kind_, input, rise_, base_, time, dt_);
  shear_.step(base_.x);
  dilation_.step(base_.y);
}

ColumnSample LinearColumn::sample(const ColumnMesh::Place& place) const {
  const auto [element, fraction] = place;
  const ScalarSample x = shear_.sample(element, fraction);
  const ScalarSample y = dilation_.sample(element, fraction);
  const ColumnMesh::Centres centres = mesh_.centres(place);
  const auto strain = [&](const ScalarColumn& column) {
    return std::lerp(column.strain(centres.lower), column.strain(centres.upper), centres.weight);
  };
  return {.vx = x.velocity,
          .vy = y.velocity,
          .sxx = lateral_ratio_[element] * y.traction,
          .syy = y.traction,
          .sxy = x.traction,
          .vx_rate = x.acceleration,
          .vy_rate = y.acceleration,
          .sxx_rate = lateral_ratio_[element] * y.traction_rate,
          .syy_rate = y.traction_rate,
          .sxy_rate = x.traction_rate,
          .ux = x.displacement,
          .uy = y.displacement,
          .eyy = strain(dilation_),
          .gxy = strain(shear_)};
}

ColumnEnergy LinearColumn::energy() const {
  const ColumnEnergy x = shear_.energy();
  const ColumnEnergy y = dilation_.energy();
  return {.kinetic = x.kinetic + y.kinetic,
          .strain = x.strain + y.strain,
          .damping = x.damping + y.damping,
          .base_work = x.base_work + y.base_work};
}

} // namespace tremolo::freefield
