// Constant damping beside a law that yields: what mechanisms add to the loops of a hyperbola by Masing's
// rules, and by how much they overshoot its strength, against the numbers of a program written apart from
// this one.

#include "materials/hysteretic/masing_shear.hpp"
#include "materials/law/law.hpp"
#include "materials/relaxation/constant_damping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace tremolo::materials {
namespace {

constexpr double reference_strain = 1e-3;
const Elasticity elastic = Elasticity::from_wave_speeds(1900.0, 200.0, 400.0);
const Law hyperbola = MasingShear{elastic, reference_strain};
const double strength = elastic.shear_modulus() * reference_strain;

/// One point in shear, in steps of dt.
class Point {
public:
  Point(const Relaxation& damping, double dt) : damping_(damping), q_(damping.time.size()) {
    for (const StateVariable& variable : state_variables(hyperbola))
      state_.push_back(variable.initial);
    for (std::size_t j = 0; j < q_.size(); ++j)
      steps_.push_back(relaxation_step(damping, j, dt));
  }

  double stress_after(double strain_increment) {
    const double before = sxy_;
    const double none = 0.0, seen = damping_.relaxed * strain_increment;
    Points point;
    point.count = 1;
    point.sxx = &sxx_;
    point.syy = &syy_;
    point.szz = &szz_;
    point.sxy = &sxy_;
    point.state = state_.data();
    point.plastic_work = &plastic_work_;
    point.dexx = point.deyy = point.dwxy = &none;
    point.dgxy = &seen;
    update(hyperbola, point);
    double sum = sxy_;
    for (std::size_t j = 0; j < q_.size(); ++j)
      sum += q_[j] = steps_[j].kept * q_[j] + steps_[j].taken * (sxy_ - before);
    return sum;
  }

private:
  Relaxation damping_;
  std::vector<RelaxationStep> steps_;
  std::vector<double> q_, state_;
  double sxx_ = 0.0, syy_ = 0.0, szz_ = 0.0, sxy_ = 0.0, plastic_work_ = 0.0;
};

struct Loop {
  double damping = 0.0; ///< W/(4 pi W_s), W_s by half of the products of the peaks
  double peak = 0.0;    ///< stress over strength
};

/// The last of some periods.
Loop loop(const Relaxation& damping, double amplitude, double frequency) {
  constexpr int steps = 1000;
  const int periods = std::max(4, static_cast<int>(std::ceil(10.0 * frequency)));
  const double dt = 1.0 / (frequency * steps);
  Point point(damping, dt);
  double work = 0.0, lowest = 0.0, highest = 0.0, largest = 0.0, before = 0.0;
  const auto strain = [&](int n) { return amplitude * std::sin(2.0 * std::numbers::pi * n / steps); };
  for (int n = 0; n < periods * steps; ++n) {
    const double increment = strain(n + 1) - strain(n);
    const double stress = point.stress_after(increment);
    largest = std::max(largest, std::abs(stress));
    if (n >= (periods - 1) * steps) {
      work += 0.5 * (before + stress) * increment;
      lowest = std::min(lowest, stress);
      highest = std::max(highest, stress);
    }
    before = stress;
  }
  return {work / (std::numbers::pi * (highest - lowest) * amplitude), largest / strength};
}

TEST(RelaxationBesideAHyperbola, AddsItsRatioAndHardlyToTheStrength) {
  const Relaxation none, damped = relaxation({3.0, {}}, 0.02);
  struct Row {
    double strain, alone, added;
  };
  for (const auto& [strain, alone, added] :
       {Row{1e-4, 0.020, 0.018}, Row{1e-3, 0.145, 0.008}, Row{1e-2, 0.428, 0.009}}) {
    const double by_law = loop(none, strain, 1.0).damping, with = loop(damped, strain, 1.0).damping;
    std::printf("%g: %.4f, added %.4f\n", strain, by_law, with - by_law);
    EXPECT_NEAR(by_law, alone, 1e-3) << strain;
    EXPECT_NEAR(with - by_law, added, 1.5e-3) << strain;
  }
  const double slow = loop(damped, 1e-2, 1.0).peak, fast = loop(damped, 1e-2, 8.0).peak;
  std::printf("peak over strength: alone %.3f, 1 Hz %.3f, 8 Hz %.3f\n", loop(none, 1e-2, 1.0).peak, slow,
              fast);
  EXPECT_NEAR(loop(none, 1e-2, 1.0).peak, 0.91, 5e-3);
  EXPECT_NEAR(slow, 0.97, 7e-3);
  EXPECT_NEAR(fast, 1.02, 7e-3);
}

} // namespace
} // namespace tremolo::materials
