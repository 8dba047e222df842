// Bodies lighter than the liquefied soil around them: how fast they begin to rise, and that friction, which
// knows effective stress alone, does not hold them, but holds them back where some of that is left.

#include "tests/support/liquefied_tunnel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;
using heavy_fluid::gravity;
using heavy_fluid::saturated;

/// Acceleration over 10 ms from rest of a smooth cylinder in a heavy fluid, over that of one far from all
/// walls, which moves as if it carried its own volume of fluid along: (rho_sat - rho_b) g/(rho_b + rho_sat).
double acceleration_over_exact(double h) {
  constexpr double density = 300.0, radius = 1.0, duration = 0.01; // kg/m3, m, s
  Spec spec = saturated_flat_ground(12.0, 10.0, h, materials::Drainage::undrained, 1e5);
  materials::MohrCoulomb grains; // that bear no tension, and nothing where they are liquefied
  grains.elastic = {saturated, 1e5, 0.3};
  grains.friction_peak = grains.friction_residual = 0.5;
  spec.soils.front().law = grains;
  spec.water->fluid.bulk_modulus = 5e8;
  spec.sides = Sides::periodic;
  spec.below_base = materials::Elasticity{2600.0, 1e13, 0.2};
  spec.structures = {structure(circle({0.0, -5.0}, radius), density, 0.0)};
  Domain domain(spec);
  liquefy(domain); // no gravity stage: the fluid's pressure is all that there is
  Stepper stepper(domain, 0.0, quiet_ground());
  while (stepper.time() < duration)
    stepper.step();
  const double speed = domain.contact.bodies().front().motion().velocity.y;
  return speed / stepper.velocity_time() * (density + saturated) / ((saturated - density) * gravity);
}

TEST(LightCylinder, RisesAgainstTheFluidThatItDisplaces) {
  const double coarse = acceleration_over_exact(0.5); // four cells across
  const double middle = acceleration_over_exact(0.25);
  const double fine = acceleration_over_exact(0.125);
  RecordProperty("coarse", std::to_string(coarse));
  RecordProperty("middle", std::to_string(middle));
  RecordProperty("fine", std::to_string(fine));
  EXPECT_GT(coarse, 0.0);
  EXPECT_LT(std::abs(middle - 1.0), 0.6 * std::abs(coarse - 1.0));
  EXPECT_LT(std::abs(fine - 1.0), 0.6 * std::abs(middle - 1.0));
  EXPECT_NEAR(fine, 1.0, 0.1);
}

/// A light shaft, 1 m wide and 6 m deep, in sand that has liquefied but for a residual strength s_u = 7 kPa.
/// The fluid's weight less its own lifts it with 96 kN/m. Suction and flow under its base hold it with some 9
/// s_u = 63 kN/m; what sticks to its sides would hold it with another 12 s_u = 84 kN/m.
class LightShaft : public testing::Test {
protected:
  static constexpr double width = 1.0, depth = 6.0, friction = 0.4; // m
  static constexpr double strength = 7e3;                           // Pa

  static constexpr auto none = [](double) { return 0.0; };

  /// How far it has risen after a time, m. The ground is layered so that each layer may have an adhesion.
  /// @param adhesion  to soil at a depth (m), Pa
  /// @param mu        friction
  /// @param left      share of the effective stress that is left
  /// @param side      distance of the domain's sides from the middle of the shaft, m
  template <class Adhesion>
  static double risen(const Adhesion& adhesion, double mu, double left, double side) {
    constexpr double layer = 0.5, base = 9.0; // m
    Spec spec = saturated_flat_ground(2.0 * side, base, 0.25, materials::Drainage::undrained, 2e7);
    materials::MohrCoulomb sand;
    sand.elastic = {saturated, 2e7, 0.3};
    sand.cohesion_peak = sand.cohesion_residual = strength;
    spec.soils.front().law = sand;
    const Soil soil = spec.soils.front();
    spec.soils.clear();
    spec.regions.clear();
    spec.sides = Sides::periodic;
    spec.below_base = materials::Elasticity{2600.0, 1e13, 0.2};
    spec.water->fluid.bulk_modulus = 5e8;
    spec.structures = {structure(rectangle(-0.5 * width, -depth, 0.5 * width, 1.0), 300.0, mu)};
    spec.structures.front().friction.clear();
    spec.structures.front().adhesion.clear();
    for (std::size_t k = 0; layer * static_cast<double>(k) < base; ++k) {
      const double top = -layer * static_cast<double>(k);
      spec.soils.push_back(soil);
      spec.soils.back().name += std::to_string(k);
      spec.regions.push_back({k, rectangle(-side, top - layer, side, top)});
      spec.structures.front().friction.push_back(mu);
      spec.structures.front().adhesion.push_back(adhesion(-top + 0.5 * layer));
    }
    StandingScene scene(spec);
    leave_effective_stress(scene.domain, left);
    scene.run(0.3);
    return scene.body().centre().y - scene.body().start().y;
  }
};

TEST_F(LightShaft, RisesThoughWaterPressesOnItsSides) {
  const double right = risen(none, friction, 0.0, 5.0);
  EXPECT_GT(right, 0.03);
  RecordProperty("risen", std::to_string(right));
}

class AcceptanceLightShaft : public LightShaft {};

TEST_F(AcceptanceLightShaft, WouldBeHeldByFrictionOfAllThatGrainsBear) {
  constexpr double side = 5.0;
  const double right = risen(none, friction, 0.0, side);
  // Wrong: friction of the impulse on the grains, which bear (1 - n) p at the wall.
  const double wrong =
      risen([](double y) { return friction * (1.0 - heavy_fluid::porosity) * saturated * gravity * y; },
            friction, 0.0, side);
  EXPECT_LT(wrong, 0.1 * right);
  RecordProperty("risen", std::to_string(right));
  RecordProperty("risen_by_wrong_friction", std::to_string(wrong));
}

TEST_F(AcceptanceLightShaft, FrictionHoldsItBackByTheEffectiveStressThatIsLeft) {
  // The lift less what holds its base is some 19 kN/m. A fifth is left of the earth pressure at rest
  // on both sides, which is 0.43 times the vertical one, 141 kN/m, and friction makes 11 kN/m of it.
  const double smooth = risen(none, 0.0, 0.2, 8.0);
  const double rough = risen(none, friction, 0.2, 8.0);
  EXPECT_GT(rough, 0.01);
  EXPECT_LT(rough, 0.8 * smooth);
  RecordProperty("risen_without_friction", std::to_string(smooth));
  RecordProperty("risen_with_friction", std::to_string(rough));
}

} // namespace
} // namespace tremolo::mpm_domain
