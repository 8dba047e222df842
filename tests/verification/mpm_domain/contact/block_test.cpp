#include "tests/support/structure_scene.hpp"
#include <gtest/gtest.h>
#include <cstdio>
#include <numbers>
namespace tremolo::mpm_domain {
namespace {
using namespace test_support;

Spec incline(double degrees, double h, double friction, double young = 2e9) {
  const double slope = std::tan(degrees * std::numbers::pi / 180.0);
  const double top = std::ceil(4.0 * slope / h) * h;
  const double toe = -top;
  Spec spec;
  spec.box = {-8.0, -10.0, 8.0, 8.0};
  spec.cell_size = h;
  spec.gravity = 9.81;
  spec.soils = {{"rock", materials::LinearElastic{{2000.0, young, 0.2}}}};
  spec.regions = {{0, {{-8.0, -10.0}, {8.0, -10.0}, {8.0, top}, {top / slope, top}, {toe / slope, toe}, {-8.0, toe}}}};
  spec.threads = 2;
  spec.structures = {structure(turned(rectangle(-1.0, 0.0, 1.0, 1.0), {0.0, 0.0}, degrees * std::numbers::pi / 180.0), 2000.0, friction)};
  return spec;
}

TEST(Explore, Incline) {
  for (double h : {0.5})
    for (double degrees : {5.0, 10.0, 20.0, 30.0, 45.0})
      for (double share : {0.0, 0.8, 0.98, 1.02}) {
      const double a = degrees * std::numbers::pi / 180.0;
      const double mu = share * std::tan(a);
      StandingScene scene(incline(degrees, h, mu));
      const Vector p0 = scene.body().centre();
      scene.run(0.8);
      const Vector p = scene.body().centre();
      const double t = scene.stepper.time();
      const double way = -((p.x - p0.x) * std::cos(a) + (p.y - p0.y) * std::sin(a));
      const double off = ((p.y - p0.y) * std::cos(a) - (p.x - p0.x) * std::sin(a));
      const double exact = 9.81 * (std::sin(a) - mu * std::cos(a)) * 0.5 * t * t;
      const auto& e = scene.domain.energy;
      std::printf("h %g deg %g share %g slipping %d way %.5f exact %.5f ratio %.4f off %.2e tilt %.2e fric %.4g imp %.3g res %.3g grav %.4g kin %.4g el %.3g nodes %zu\n", h, degrees, share, scene.reactions.slipping, way, exact, way / exact, off, scene.body().tilt(), e.friction, e.impact, e.residual(), e.gravity, e.kinetic, e.elastic, scene.domain.contact.nodes(0).size());
    }
}
}
}
