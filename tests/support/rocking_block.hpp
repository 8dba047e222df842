#pragma once

// A slender block that rocks on stiff ground, as Housner (1963) has it: with alpha its angle of overturning
// and R half its diagonal, half a cycle from the ground and back takes 2 acosh(1/(1 - theta/alpha))/p with
// p^2 = 3 g/(4 R), and each impact leaves the share r = 1 - 3/2 sin^2 alpha of the spin.

#include "tests/support/structure_scene.hpp"

#include <cmath>
#include <vector>

namespace tremolo::test_support {

class RockingBlock {
public:
  static constexpr double gravity = 9.81;            // m/s2
  static constexpr double width = 1.0, height = 4.0; // m
  static constexpr double density = 2000.0;          // kg/m3
  static inline const double radius = 0.5 * std::hypot(width, height);
  static inline const double alpha = std::atan2(width, height);
  static inline const double restitution = 1.0 - 1.5 * std::pow(std::sin(alpha), 2);

  /// On ground of 2 GPa, in cells of a quarter of its width; rigid.
  static mpm_domain::Spec spec() {
    mpm_domain::Spec spec = flat_ground(6.0, 1.5, 0.25, {2000.0, 2e9, 0.2});
    spec.structures = {structure(rectangle(-0.5 * width, 0.0, 0.5 * width, height), density, 1.0)};
    return spec;
  }

  /// Time from rest at a tilt (rad) to the ground, s.
  static double quarter_period(double tilt) {
    const double p = std::sqrt(3.0 * gravity / (4.0 * radius));
    return std::acosh(1.0 / (1.0 - tilt / alpha)) / p;
  }

  /// Energy of a tilt (rad), over M g R.
  static double lift(double tilt) { return std::cos(alpha - tilt) - std::cos(alpha); }

  /// Takes the block up to half its angle of overturning about its left toe.
  explicit RockingBlock(const mpm_domain::Spec& spec) : scene(spec) { push(); }

  /// Runs for 2.1 s, past the second time that it stands still in the air if all goes as it should. The
  /// largest tilt to a side counts, since an elastic block sways besides.
  void run() {
    double side = 1.0;
    Peak most{};
    const auto keep = [&] {
      if (most.tilt > 0.0 && most.time < scene.stepper.time() - 0.02)
        peaks.push_back(most);
      most = {};
    };
    while (scene.stepper.time() < 2.1) {
      scene.stepper.step();
      const double tilt = side * scene.body().tilt();
      if (tilt > most.tilt)
        most = {scene.stepper.time(), tilt};
      if (tilt < -0.05 * alpha) {
        keep();
        side = -side;
      }
    }
    keep();
  }

  /// Time between the first two peaks over what the tilts there ask for.
  double half_cycle_over_exact() const {
    return (peaks.at(1).time - peaks.at(0).time) /
           (quarter_period(peaks.at(0).tilt) + quarter_period(peaks.at(1).tilt));
  }
  /// Share of the spin that the impact between them left.
  double measured_restitution() const { return std::sqrt(lift(peaks.at(1).tilt) / lift(peaks.at(0).tilt)); }
  /// Kinetic energy that it was given, J/m.
  double given() const { return 0.5 * scene.body().mass() * (4.0 / 3.0) * radius * radius * spin * spin; }

  /// Where it stands still.
  struct Peak {
    double time, tilt; ///< s, rad
  };
  const double spin = std::sqrt(1.5 * gravity / radius * lift(0.5 * alpha)); ///< at the start, rad/s
  StandingScene scene;
  std::vector<Peak> peaks;

private:
  void push() { set_motion(scene.domain, 0, {{-spin * 0.5 * height, spin * 0.5 * width}, spin}); }
};

} // namespace tremolo::test_support
