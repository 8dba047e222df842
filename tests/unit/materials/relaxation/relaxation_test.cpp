// Relaxation mechanisms in time against their modulus.

#include "materials/relaxation/constant_damping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace tremolo::materials {
namespace {

using Complex = std::complex<double>;

const Relaxation soil = relaxation({3.0, {}}, 0.05);

/// Stress of soil with G = 1 in steps of dt, for strain increments.
class Element {
public:
  explicit Element(double dt) : q_(soil.time.size()) {
    for (std::size_t j = 0; j < q_.size(); ++j)
      steps_.push_back(relaxation_step(soil, j, dt));
  }

  double stress_after(double strain_increment) {
    const double of_law = soil.relaxed * strain_increment;
    law_ += of_law;
    double sum = law_;
    for (std::size_t j = 0; j < q_.size(); ++j)
      sum += q_[j] = steps_[j].kept * q_[j] + steps_[j].taken * of_law;
    return sum;
  }

private:
  double law_ = 0.0;
  std::vector<double> q_;
  std::vector<RelaxationStep> steps_;
};

/// G* of steps under a strain sin(wt) that has gone on for long, from one of its periods.
Complex measured(double frequency, int steps_per_period) {
  const double dt = 1.0 / (frequency * steps_per_period);
  const double w = 2.0 * std::numbers::pi * frequency;
  Element element(dt);
  const int begin = static_cast<int>(std::ceil(20.0 * soil.time.front() * frequency)) * steps_per_period;
  Complex sum = 0.0;
  for (int n = 0; n < begin + steps_per_period; ++n) {
    const double stress = element.stress_after(std::sin(w * (n + 1) * dt) - std::sin(w * n * dt));
    if (n >= begin)
      sum += stress * std::polar(1.0, -w * (n + 1) * dt);
  }
  return sum * Complex(0.0, 2.0 / steps_per_period);
}

TEST(RelaxationSteps, HaveTheModulusToSecondOrder) {
  for (const double frequency : {0.2, 3.0, 20.0}) {
    const Complex exact = soil.factor({0.0, 2.0 * std::numbers::pi * frequency});
    const double coarse = std::abs(measured(frequency, 40) - exact),
                 fine = std::abs(measured(frequency, 80) - exact);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.05) << frequency;
    EXPECT_LT(fine, 1e-3) << frequency;
  }
}

TEST(RelaxationSteps, EndWithTheRelaxedStiffness) {
  Element element(1e-3);
  EXPECT_NEAR(element.stress_after(1.0), soil.unrelaxed(), 0.05 * soil.unrelaxed());
  double stress = 0.0;
  for (int n = 0; n < 40'000; ++n)
    stress = element.stress_after(0.0);
  EXPECT_NEAR(stress, soil.relaxed, 1e-8);
}

/// K + 4/3 G with water in K: what relaxes is G alone.
TEST(Relaxation, OnAShareLeavesTheRestAsItIs) {
  constexpr double share = 0.1;
  const Relaxation part = soil.on_share(share);
  const Complex s(0.0, 30.0);
  EXPECT_NEAR(std::abs(part.factor(s) - (1.0 - share + share * soil.factor(s))), 0.0, 1e-15);
  EXPECT_NEAR(part.unrelaxed(), 1.0 - share + share * soil.unrelaxed(), 1e-15);
}

} // namespace
} // namespace tremolo::materials
