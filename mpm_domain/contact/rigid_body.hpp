#pragma once

// A rigid body in the plane: U = (V, omega) at its centre of mass X, tilt theta. Weight and the water that it
// displaces move it,
//
//     M dV/dt = -M g e_y + gamma A_w e_y,        I domega/dt = gamma A_w (x_w - X) . e_x,
//
// with A_w and x_w area and centroid of the part of its outline below the water table: hydrostatic pressure
// acts on all of the outline there. Where the head varies, pressure p_0 = max(gamma (h - y), 0) is added up
// along the outline,
//
//     F = -int p_0 n ds,        M = -int p_0 (x - X) x n ds.
//
// Everything else, effective stress and excess pressure, comes through
// contact (rigid_contact.hpp). V and omega belong to the same times as velocities of particles, X and theta
// to those of their positions.

#include "mpm_domain/contact/body_surface.hpp"
#include "mpm_domain/head/head.hpp"
#include "mpm_domain/spec/structure.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// Motion of a rigid body, or an increment of it.
struct RigidMotion {
  Vector velocity;   ///< V of the centre of mass, m/s
  double spin = 0.0; ///< omega, counter-clockwise, rad/s

  /// Velocity of the body's point at an arm (m) from the centre of mass.
  Vector at(const Vector& arm) const { return {velocity.x - spin * arm.y, velocity.y + spin * arm.x}; }
};

/// Force and moment about the centre of mass, per metre out of plane.
struct RigidLoad {
  Vector force;        ///< N/m
  double moment = 0.0; ///< N

  friend RigidLoad operator+(const RigidLoad& a, const RigidLoad& b) {
    return {a.force + b.force, a.moment + b.moment};
  }
};

/// Undisturbed water around a body.
struct WaterAround {
  const Head& head;
  double unit_weight = 0.0; ///< N/m3
};

class RigidBody {
public:
  /// Creates the body at rest at the structure's position.
  /// @throws std::invalid_argument for an outline without area, or a density that is not positive
  explicit RigidBody(const Structure& structure);

  const std::string& name() const { return name_; }
  double mass() const { return mass_; }       ///< M, kg/m
  double inertia() const { return inertia_; } ///< I, kg m
  const Vector& centre() const { return centre_; }
  double tilt() const { return tilt_; } ///< theta, counter-clockwise, rad
  /// Initial position of the centre of mass, m.
  const Vector& start() const { return start_; }
  const RigidMotion& motion() const { return motion_; }
  void set_motion(const RigidMotion& motion) { motion_ = motion; }
  double kinetic_energy() const; ///< J/m

  const BodySurface& surface() const { return surface_; }
  /// Its corners now, counter-clockwise, m.
  const std::vector<Vector>& outline() const { return surface_.points(); }
  /// Corners of its hole now.
  std::vector<Vector> hole() const;
  Vector arm(const Vector& position) const { return position - centre_; }

  /// Weight and, with water around it, buoyancy.
  RigidLoad load(double gravity, const std::optional<WaterAround>& water) const;

  /// Moves by its velocity for dt (s).
  void move(double dt);

  /// X, theta, V and omega, for a checkpoint, and back.
  std::vector<double> state() const;
  void set_state(const std::vector<double>& state);

private:
  void add_pressure(RigidLoad& load, const WaterAround& water) const;
  std::vector<Vector> turned(const std::vector<Vector>& corners) const;

  std::string name_;
  std::vector<Vector> corners_, hole_; ///< from the centre of mass, before any tilt
  double mass_ = 0.0;
  double inertia_ = 0.0;
  Vector start_, centre_;
  double tilt_ = 0.0;
  RigidMotion motion_;
  BodySurface surface_;
};

} // namespace tremolo::mpm_domain
