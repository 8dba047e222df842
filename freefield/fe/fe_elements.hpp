#pragma once

// The semi-discrete column shared by all integrators of nonlinear soil, per m2 of plan area. Two degrees of
// freedom a node, x and y, stored as u[2 i], u[2 i + 1]; element e with length h joins nodes e and e+1,
//
//     gxy = (ux_{e+1} - ux_e)/h,   eyy = (uy_{e+1} - uy_e)/h,
//     m a + r = 0,   r = [tau_below - tau_above] + c (v - v_ref) - f,   tau = sigma - sigma_0 + beta D_0 d
//     eps/dt,
//
// tau = (sxy, syy) on a face with normal +y, sigma_0 the geostatic stress, which balances gravity, D_0 = (G,
// M) at small strain, c = alpha m, v_ref of base_motion.hpp; a compliant base adds rho c_0 (v - 2 v_incident)
// to its node. Strains are small and stresses are not rotated with the soil.

#include "freefield/base_motion.hpp"
#include "freefield/fe/column_mesh.hpp"
#include "freefield/fe/fe_soil.hpp"
#include "freefield/profile.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::freefield {

/// Constants of one element.
struct FeElement {
  double length = 0.0;             ///< m
  double density = 0.0;            ///< kg/m3
  double alpha = 0.0;              ///< mass-proportional damping, 1/s
  double damping_time = 0.0;       ///< beta, stiffness-proportional damping, s
  double shear_viscosity = 0.0;    ///< beta G, Pa s
  double dilation_viscosity = 0.0; ///< beta M, Pa s
  double lateral_ratio = 0.0;      ///< lambda/M, sxx over syy where soil is elastic
};

class FeElements {
public:
  using Vector = std::vector<double>; ///< two values a node, from the base up

  FeElements(const Profile& profile, const ColumnMesh& mesh, const Damping& damping, BaseKind base);

  std::size_t count() const { return elements_.size(); }
  std::size_t freedoms() const { return mass_.size(); }
  /// Degrees of freedom that are prescribed: the first two, or none.
  std::size_t prescribed() const { return base_ == BaseKind::rigid ? 2 : 0; }
  const FeElement& operator[](std::size_t element) const { return elements_[element]; }
  const Vector& mass() const { return mass_; } ///< kg/m2
  const Vector& inverse_mass() const { return inverse_mass_; }
  const Vector& dashpots() const { return dashpots_; } ///< mass-proportional ones and the base's, Pa s/m
  const Vector& mass_damping() const { return mass_damping_; } ///< alpha times mass, Pa s/m

  /// Strain increments of a displacement increment.
  void strains(const Vector& du, Vector& deyy, Vector& dgxy) const;

  /// r of the header, Pa: elements' stresses with the damping stress of `stress_velocity`, dashpots with `v`
  /// and v_ref of `base`.
  void resistance(const FeSoil& soil, const SoilState& state, const Vector& stress_velocity, const Vector& v,
                  const BaseMotion& base, Vector& r) const;

  /// Traction of a compliant base on the column, Pa.
  Velocity base_traction(const Vector& v, const BaseMotion& base) const;

private:
  std::vector<FeElement> elements_;
  BaseKind base_;
  double impedance_x_;
  double impedance_y_;
  Vector mass_;
  Vector inverse_mass_;
  Vector mass_damping_;
  Vector dashpots_;
};

} // namespace tremolo::freefield
