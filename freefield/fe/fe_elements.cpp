#include "freefield/fe/fe_elements.hpp"

#include <cmath>

namespace tremolo::freefield {

FeElements::FeElements(const Profile& profile, const ColumnMesh& mesh, const Damping& damping, BaseKind base)
    : base_(base), impedance_x_(profile.half_space.density * profile.half_space.s_wave_speed()),
      impedance_y_(profile.half_space.density * profile.half_space.p_wave_speed()),
      mass_(2 * mesh.node_y.size()), mass_damping_(mass_.size()) {
  elements_.reserve(mesh.elements());
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    const Layer& layer = profile.layers[mesh.element_layer[e]];
    const materials::Elasticity& soil = layer.soil;
    const DampingCoefficients c = coefficients(damping, layer.damping_ratio);
    elements_.push_back({mesh.length(e), soil.density, c.alpha, c.beta, c.beta * soil.shear_modulus(),
                         c.beta * soil.p_modulus(), soil.lame() / soil.p_modulus()});
    const double half_mass = 0.5 * soil.density * mesh.length(e);
    for (std::size_t freedom = 2 * e; freedom < 2 * e + 4; ++freedom) {
      mass_[freedom] += half_mass;
      mass_damping_[freedom] += c.alpha * half_mass;
    }
  }
  dashpots_ = mass_damping_;
  inverse_mass_.reserve(mass_.size());
  for (const double mass : mass_)
    inverse_mass_.push_back(1.0 / mass);
  if (base_ == BaseKind::compliant) {
    dashpots_[0] += impedance_x_;
    dashpots_[1] += impedance_y_;
  }
}

void FeElements::strains(const Vector& du, Vector& deyy, Vector& dgxy) const {
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const double scale = 1.0 / elements_[e].length;
    dgxy[e] = scale * (du[2 * e + 2] - du[2 * e]);
    deyy[e] = scale * (du[2 * e + 3] - du[2 * e + 1]);
  }
}

void FeElements::resistance(const FeSoil& soil, const SoilState& state, const Vector& stress_velocity,
                            const Vector& v, const BaseMotion& base, Vector& r) const {
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] = dashpots_[i] * v[i] - mass_damping_[i] * (i % 2 == 0 ? base.x : base.y).reference;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const FeElement& element = elements_[e];
    const double scale = 1.0 / element.length;
    const double shear = soil.shear(state, e) + element.shear_viscosity * scale *
                                                    (stress_velocity[2 * e + 2] - stress_velocity[2 * e]);
    const double vertical =
        soil.vertical(state, e) +
        element.dilation_viscosity * scale * (stress_velocity[2 * e + 3] - stress_velocity[2 * e + 1]);
    r[2 * e] -= shear;
    r[2 * e + 1] -= vertical;
    r[2 * e + 2] += shear;
    r[2 * e + 3] += vertical;
  }
  if (base_ == BaseKind::compliant) {
    r[0] -= 2.0 * impedance_x_ * base.x.velocity;
    r[1] -= 2.0 * impedance_y_ * base.y.velocity;
  }
}

Velocity FeElements::base_traction(const Vector& v, const BaseMotion& base) const {
  return {impedance_x_ * (2.0 * base.x.velocity - v[0]), impedance_y_ * (2.0 * base.y.velocity - v[1])};
}

} // namespace tremolo::freefield
