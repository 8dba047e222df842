#pragma once

// Structures on or in the ground, without processes: brought to rest under gravity, then left to themselves
// or shaken through their faces.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/quiet_ground.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::test_support {

inline std::vector<Vector> rectangle(double x_min, double y_min, double x_max, double y_max) {
  return {{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}};
}

/// A polygon of many corners with the area of a circle.
inline std::vector<Vector> circle(const Vector& centre, double radius, int corners = 64) {
  const double angle = 2.0 * std::acos(-1.0) / corners;
  const double reach = radius * std::sqrt(angle / std::sin(angle));
  std::vector<Vector> polygon;
  for (int k = 0; k < corners; ++k)
    polygon.push_back({centre.x + reach * std::cos(angle * k), centre.y + reach * std::sin(angle * k)});
  return polygon;
}

inline std::vector<Vector> turned(std::vector<Vector> polygon, const Vector& about, double angle) {
  for (Vector& p : polygon) {
    const Vector d{p.x - about.x, p.y - about.y};
    p = {about.x + std::cos(angle) * d.x - std::sin(angle) * d.y,
         about.y + std::sin(angle) * d.x + std::cos(angle) * d.y};
  }
  return polygon;
}

/// A structure against one soil.
inline mpm_domain::Structure structure(std::vector<Vector> outline, double density, double friction) {
  return {.name = "block",
          .outline = std::move(outline),
          .density = density,
          .friction = {friction},
          .adhesion = {0.0},
          .friction_between = friction};
}

/// Gives the bodies places and motions, as a checkpoint does: x, y, tilt, velocities along x and y, spin.
inline void set_bodies(mpm_domain::Domain& domain, const std::vector<std::vector<double>>& states) {
  struct {
    const std::vector<std::vector<double>>& states;
    std::vector<double> numbers(const std::string& name) const {
      for (std::size_t b = 0; b < states.size(); ++b)
        if (name == "body" + std::to_string(b))
          return states[b];
      return {};
    }
  } const checkpoint{states};
  domain.contact.restore(checkpoint);
}

/// Lets a body move as a whole from where it stands, elastic or rigid.
inline void set_motion(mpm_domain::Domain& domain, std::size_t which, const mpm_domain::RigidMotion& motion) {
  std::vector<std::vector<double>> states;
  for (const mpm_domain::RigidBody& body : domain.contact.bodies())
    states.push_back(body.state());
  const Vector centre = domain.contact.bodies()[which].centre();
  std::ranges::copy(std::initializer_list<double>{motion.velocity.x, motion.velocity.y, motion.spin},
                    states[which].begin() + 3);
  if (!domain.contact.is_elastic(which))
    return set_bodies(domain, states);
  // Affine velocities of particles at quarters of cells: xi (1 - xi) and the box's part.
  const double quarter = 0.25 * domain.finest_lattice().h;
  const double moment = 3.0 * quarter * quarter;
  for (mpm_domain::Particles& set : domain.sets)
    for (std::size_t k = 0; set.body && k < set.size(); ++k) {
      if (domain.contact.structure_of(*set.body) != which)
        continue;
      const Vector v = motion.at({set.x[k] - centre.x, set.y[k] - centre.y});
      set.vx[k] = v.x;
      set.vy[k] = v.y;
      set.bxy[k] = -motion.spin * moment;
      set.byx[k] = motion.spin * moment;
    }
}

/// How deep a corner of one body lies in the other, m.
inline double overlap(const mpm_domain::RigidBody& a, const mpm_domain::RigidBody& b) {
  double deepest = 0.0;
  for (const auto& [owner, other] : {std::pair{&a, &b}, std::pair{&b, &a}})
    for (const Vector& corner : owner->outline())
      deepest = std::max(deepest, -other->surface().nearest(corner).distance);
  return deepest;
}

/// Leaves a share of the effective stress of wet soil; the excess pressure bears the rest of its buoyant
/// weight. The ground surface lies at y = 0.
inline void leave_effective_stress(mpm_domain::Domain& domain, double share) {
  for (mpm_domain::Particles& p : domain.sets)
    for (std::size_t k = 0; p.traits.wet && k < p.size(); ++k) {
      const double buoyant_weight = p.weight_share * p.density * domain.spec.gravity;
      for (double* stress : {&p.sxx[k], &p.syy[k], &p.szz[k], &p.sxy[k]})
        *stress *= share;
      p.pore_pressure[k] = rest_pressure(p, k) - (1.0 - share) * buoyant_weight * p.y[k];
    }
}

inline void liquefy(mpm_domain::Domain& domain) {
  leave_effective_stress(domain, 0.0);
}

/// Flat ground of one elastic soil with its surface at y = 0.
inline mpm_domain::Spec flat_ground(double width, double depth, double h, const materials::Elasticity& soil) {
  mpm_domain::Spec spec;
  spec.box = {-0.5 * width, -depth, 0.5 * width, 0.0};
  spec.cell_size = h;
  spec.gravity = 9.81;
  spec.soils = {{"soil", materials::LinearElastic{soil}}};
  spec.regions = {{0, rectangle(-0.5 * width, -depth, 0.5 * width, 0.0)}};
  spec.threads = 2;
  return spec;
}

/// A domain at rest under gravity whose shaking begins.
class StandingScene {
public:
  /// @param then  the static stages after gravity
  explicit StandingScene(const mpm_domain::Spec& spec, mpm_domain::FreeFieldSource source = quiet_ground(),
                         double residual = 1e-9, std::span<const mpm_domain::StaticStage> then = {})
      : domain(spec), reactions(mpm_domain::bring_to_rest(domain, {.residual = residual}, then,
                                                          [](std::size_t, long, double) {})),
        stepper(start(), 0.0, std::move(source)) {}

  void run(double duration) {
    const double end = stepper.time() + duration;
    while (stepper.time() < end)
      stepper.step();
  }
  const mpm_domain::RigidBody& body(std::size_t which = 0) const { return domain.contact.bodies()[which]; }

  mpm_domain::Domain domain;
  mpm_domain::Reactions reactions;
  mpm_domain::Stepper stepper;

private:
  mpm_domain::Domain& start() {
    mpm_domain::replace_constraints(domain, reactions);
    return domain;
  }
};

} // namespace tremolo::test_support
