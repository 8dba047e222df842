#pragma once

// Random states of contact nodes, and what they add up to.

#include "mpm_domain/contact/contact_nodes.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace tremolo::mpm_domain::test {

class Draw {
public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  double decades(double low, double high) {
    return std::pow(10.0, between(std::log10(low), std::log10(high)));
  }
  Vector vector() { return {between(-1.0, 1.0), between(-1.0, 1.0)}; }
  Vector direction() {
    const double angle = between(0.0, 2.0 * std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
  }

private:
  std::mt19937 engine_;
};

/// A node of saturated soil, or of dry soil.
inline ContactNode random_node(Draw& draw, bool wet, double least_mass, double most_mass) {
  ContactNode c;
  c.normal = draw.direction();
  c.arm = draw.vector();
  c.solid_mass = draw.decades(least_mass, most_mass);
  c.solid_trial = draw.vector();
  c.water_trial = c.solid_trial;
  if (wet) {
    const double porosity = draw.between(0.3, 0.6);
    c.water_mass = c.solid_mass * porosity / ((1.0 - porosity) * 2.65);
    c.water_trial = draw.vector();
    c.full_water = c.water_mass / porosity;
    c.free_impulse = c.full_water * dot(c.normal, draw.vector());
    c.drag = 1.0 + draw.decades(1e-3, 1e6);
    c.least_water = -1e300; // suction never breaks
  }
  c.mass = c.solid_mass + c.water_mass;
  c.tangential = c.mass / (1.0 + c.water_mass / c.solid_mass / c.drag);
  c.friction = draw.between(0.0, 1.0);
  c.set_trial({});
  return c;
}

struct Totals {
  double x = 0.0, y = 0.0; ///< momentum
  double turn = 0.0;       ///< angular momentum about the body's centre
  double energy = 0.0;
  double mass = 0.0;

  void add(double m, const Vector& v, const Vector& arm) {
    x += m * v.x;
    y += m * v.y;
    turn += m * cross(arm, v);
    energy += 0.5 * m * dot(v, v);
    mass += m;
  }
};

} // namespace tremolo::mpm_domain::test
