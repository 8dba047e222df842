#include "materials/soiltest/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::soiltest {

using materials::Law;
using materials::PointState;
using materials::PointTest;

void stop_at_stress(PointTest& point, const Apparatus& apparatus, const PointState& before, double increment,
                    double target, double tolerance) {
  const auto excess = [&](double part) {
    point.set(before);
    if (part > 0.0)
      point.apply(apparatus.step(part * increment, point));
    return apparatus.shear_stress(point) - target;
  };
  double a = 0.0;
  double b = 1.0;
  double at_a = excess(a);
  double at_b = excess(b);
  int kept = 0; // which end has stayed, and how often
  bool met = std::abs(at_b) <= tolerance;
  while (!met && b - a > 1e-13) {
    const double part =
        std::clamp((a * at_b - b * at_a) / (at_b - at_a), a + 1e-3 * (b - a), b - 1e-3 * (b - a));
    const double at_part = excess(part);
    met = std::abs(at_part) <= tolerance;
    if ((at_part > 0.0) == (at_b > 0.0)) {
      b = part;
      at_b = at_part;
      at_a *= kept > 0 ? 0.5 : 1.0;
      kept = 1;
    } else {
      a = part;
      at_a = at_part;
      at_b *= kept < 0 ? 0.5 : 1.0;
      kept = -1;
    }
  }
  if (!met)
    excess(b);
}

namespace {

/// Drained simple shear from tau = 0 to a shear stress.
void shear_to(PointTest& point, const SoilTest& drained, double tau) {
  const Apparatus apparatus(drained, point);
  const double increment = std::copysign(drained.strain_increment, tau);
  PointState before = point.now();
  while (std::abs(point.stress().xy) < std::abs(tau)) {
    if (std::abs(point.strain().xy) > 1.0)
      throw std::runtime_error("100 % shear strain does not reach it");
    before = point.now();
    point.apply(apparatus.step(increment, point));
  }
  stop_at_stress(point, apparatus, before, increment, tau, 1e-9 * drained.initial.vertical_stress);
}

} // namespace

materials::PointStress stress_at_start(const SoilTest& test) {
  const InitialState& initial = test.initial;
  const double lateral = -initial.k0 * initial.vertical_stress;
  return {lateral, -initial.vertical_stress, lateral,
          initial.bias_in_initial_stress ? initial.shear_bias * initial.vertical_stress : 0.0};
}

PointTest specimen(const Law& law, const SoilTest& test) {
  const InitialState& initial = test.initial;
  const double tau = initial.shear_bias * initial.vertical_stress;
  materials::StressTolerance tolerance;
  tolerance.nearest = test.kind == Kind::path ? 0.0 : largest_missing_fraction;
  PointTest point(law, stress_at_start(test), tolerance);
  if (initial.bias_in_initial_stress || tau == 0.0)
    return point;
  SoilTest drained = test;
  drained.kind = Kind::direct_simple_shear;
  drained.drainage = Drainage::drained;
  drained.pore_stiffness = 0.0;
  try {
    shear_to(point, drained, tau);
  } catch (const std::exception& failure) {
    throw std::invalid_argument(
        fmt::format("shear_bias = {:g} cannot be applied by drained shearing: at {:g} Pa: {}",
                    initial.shear_bias, point.stress().xy, failure.what()));
  }
  PointState start = point.now();
  start.strain = {};
  point.set(start);
  return point;
}

} // namespace tremolo::soiltest
