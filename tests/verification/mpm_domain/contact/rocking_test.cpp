#include "tests/support/structure_scene.hpp"
#include <gtest/gtest.h>
#include <cmath>
#include <cstdio>
namespace tremolo::mpm_domain {
namespace {
using namespace test_support;

/// Gives a body a motion as a checkpoint would.
struct Restart {
  std::vector<double> state;
  std::vector<double> numbers(const std::string& name) const {
    return name == "body0" ? state : std::vector<double>{};
  }
};

TEST(Explore, Rocking) {
  for (double h : {0.25}) for (double young : {2e9}) {
  Spec spec = flat_ground(6.0, 1.5, h, {2000.0, young, 0.2});
  spec.structures = {structure(rectangle(-0.5, 0.0, 0.5, 4.0), 2000.0, 1.0)};
  StandingScene scene(spec);
  const double R = std::hypot(0.5, 2.0), alpha = std::atan2(0.5, 2.0);
  const double w0 = std::sqrt(1.5 * 9.81 / R * (std::cos(alpha / 2.0) - std::cos(alpha)));
  // about the left toe: positive spin
  scene.domain.contact.restore(Restart{{0.0, 2.0, 0.0, -w0 * 2.0, w0 * 0.5, w0}});
  const double p = std::sqrt(3.0 * 9.81 / (4.0 * R));
  std::printf("h %g E %g w0 %.4f p %.4f T/4 %.4f r %.4f\n", h, young, w0, p, std::acosh(2.0) / p, 1.0 - 1.5 * std::pow(std::sin(alpha), 2));
  double last = w0, peak = 0.0; double tp = 0.0;
  while (scene.stepper.time() < 3.0) {
    scene.stepper.step();
    const double tilt = scene.body().tilt();
    const double w = scene.body().motion().spin;
    if (last * w < 0.0) { std::printf(" peak tilt/alpha %.4f at %.4f  spin turned, w extreme before %.4f, x %.4f y %.4f\n", tilt / alpha, scene.stepper.time(), peak, scene.body().centre().x, scene.body().centre().y); peak = 0.0; }
    if (std::abs(w) > std::abs(peak)) peak = w;
    last = w; (void)tp;
  }
  const auto& e = scene.domain.energy;
  std::printf(" res %.3g imp %.3g fric %.3g kin %.3g grav %.3g dash %.3g tr %.3g el %.3g\n", e.residual(), e.impact, e.friction, e.kinetic, e.gravity, e.dashpots, e.transfer, e.elastic);
  }
}
}
}
