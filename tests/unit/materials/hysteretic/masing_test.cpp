// The four extended Masing rules, one by one, and the memory of a point.

#include "materials/hysteretic/masing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace tremolo::materials {
namespace {

constexpr Backbone backbone = {50e6, 4e-4, 1.0, 0.9};
using History = std::array<double, masing_history_size>;

History after(std::initializer_list<double> strains) {
  History history{};
  for (const double strain : strains) {
    masing_commit(backbone, history, strain);
  }
  return history;
}

double doubled(double strain, double reversal_strain, double reversal_stress) {
  return reversal_stress + 2.0 * backbone.stress(0.5 * (strain - reversal_strain));
}

TEST(Masing, FirstLoadingFollowsTheBackbone) {
  EXPECT_EQ(after({1e-4, 5e-4})[masing::stress], backbone.stress(5e-4));
  EXPECT_EQ(after({-2e-3})[masing::stress], backbone.stress(-2e-3));
  EXPECT_EQ(after({-2e-3})[masing::reversals], 0.0);
}

TEST(Masing, UnloadingIsTheDoubledBackbone) {
  const History top = after({1e-3});
  EXPECT_EQ(masing_stress(backbone, top, -2e-4), doubled(-2e-4, 1e-3, backbone.stress(1e-3)));
  EXPECT_NEAR(masing_tangent(backbone, top, 1e-3 - 1e-12), backbone.shear_modulus, 1e-3 * 50e6);
}

TEST(Masing, BeyondTheLargestStrainItIsTheBackboneAgain) {
  EXPECT_EQ(masing_stress(backbone, after({1e-3}), -1.2e-3), backbone.stress(-1.2e-3));
  EXPECT_EQ(masing_stress(backbone, after({1e-3, -4e-4}), 1.1e-3), backbone.stress(1.1e-3));
  EXPECT_EQ(after({1e-3, -4e-4, 1.1e-3})[masing::reversals], 0.0);
  // The other way round too: a first reversal near the origin.
  EXPECT_EQ(masing_stress(backbone, after({-1e-5}), 2e-5), backbone.stress(2e-5));
}

TEST(Masing, AnInnerLoopEndsOnTheCurveItLeft) {
  const History outer = after({1e-3, -5e-4});
  const History inner = after({1e-3, -5e-4, 2e-4, -1e-4});
  EXPECT_EQ(inner[masing::reversals], 3.0); // 1e-3, -5e-4, 2e-4; the strain is now at -1e-4
  for (const double strain : {3e-4, 9e-4}) {
    EXPECT_EQ(masing_stress(backbone, inner, strain), masing_stress(backbone, outer, strain));
  }
  EXPECT_EQ(masing_stress(backbone, inner, -6e-4), doubled(-6e-4, 1e-3, backbone.stress(1e-3)));
}

TEST(Masing, AClosedLoopLeavesNoTrace) {
  const History once = after({1e-3, -5e-4, 2e-4});
  EXPECT_EQ(after({1e-3, -5e-4, 1e-4, -3e-4, 0.0, -2e-4, 2e-4})[masing::stress], once[masing::stress]);
  EXPECT_EQ(after({1e-3, -5e-4, 1e-4, -3e-4, 0.0, -2e-4, 2e-4})[masing::reversals], once[masing::reversals]);
}

TEST(Masing, ATrialLeavesTheHistoryBitForBit) {
  const History start = after({1e-3, -5e-4, 2e-4, -1e-4});
  History history = start;
  for (const double strain : {-2e-4, 1e-4, 3e-4, -7e-4, 5e-3, -5e-3, -1e-4}) {
    const ShearResponse both = masing_response(backbone, history, strain);
    EXPECT_EQ(both.stress, masing_stress(backbone, history, strain));
    EXPECT_EQ(both.tangent, masing_tangent(backbone, history, strain));
    EXPECT_TRUE(std::equal(history.begin(), history.end(), start.begin()));
    History accepted = start;
    masing_commit(backbone, accepted, strain);
    EXPECT_EQ(accepted[masing::stress], both.stress);
  }
}

TEST(Masing, StressIsContinuousInTheTrialStrain) {
  const History history = after({1e-3, -5e-4, 2e-4, -1e-4});
  for (double strain = -1.5e-3; strain < 1.5e-3; strain += 1e-6) {
    const double change =
        masing_stress(backbone, history, strain + 1e-6) - masing_stress(backbone, history, strain);
    EXPECT_GE(change, 0.0);
    EXPECT_LE(change, 50e6 * 1e-6 * (1.0 + 1e-9)); // tangent <= G0
  }
}

TEST(Masing, ChangesBelowTheLeastAreNone) {
  const History start = after({1e-3, -5e-4});
  History history = start;
  masing_commit(backbone, history, -5e-4 + 5e-15);
  EXPECT_TRUE(std::equal(history.begin(), history.end(), start.begin()));
  EXPECT_TRUE(masing_reverses(start, 0.0));
  EXPECT_FALSE(masing_reverses(start, -6e-4));
}

/// Amplitudes that shrink by `ratio` at every reversal.
template <class Visit>
void ring_down(int reversals, double ratio, Visit visit) {
  double amplitude = 2e-3;
  for (int k = 0; k < reversals; ++k) {
    visit(k % 2 == 0 ? amplitude : -amplitude);
    amplitude *= ratio;
  }
}

/// The rules with an unbounded memory: every reversal of a shrinking sequence is still open.
double shrinking_stress(const std::vector<double>& turns, double strain) {
  double reversal_stress = backbone.stress(turns.front());
  for (std::size_t k = 1; k < turns.size(); ++k) {
    reversal_stress = doubled(turns[k], turns[k - 1], reversal_stress);
  }
  return doubled(strain, turns.back(), reversal_stress);
}

TEST(Masing, AFullMemoryKeepsStressAndDampingOfSmallerLoops) {
  History history{};
  std::vector<double> turns;
  ring_down(201, 0.97, [&](double strain) {
    if (turns.size() > 1) {
      EXPECT_NEAR(masing_stress(backbone, history, strain), shrinking_stress(turns, strain),
                  1e-9 * 50e6 * 2e-3);
    }
    masing_commit(backbone, history, strain);
    turns.push_back(strain);
  });
  EXPECT_GT(history[masing::merges], 0.0);
  EXPECT_LE(history[masing::reversals], static_cast<double>(masing_capacity));
  EXPECT_EQ(history[masing::merged], 1.0);
}

TEST(Masing, AFullMemoryErrsByNoMoreThanTheLoopItRemembers) {
  History history{};
  std::vector<double> turns;
  ring_down(201, 0.97, [&](double strain) {
    masing_commit(backbone, history, strain);
    turns.push_back(strain);
  });
  const double width = std::abs(turns[masing_capacity - 3] - turns[masing_capacity - 4]);
  const double bound = 2.0 * (2.0 * backbone.stress(0.25 * width) - backbone.stress(0.5 * width));
  // Exact continuation from the last turn: the rules 3 and 4 on the full list.
  const auto exact = [&](double strain) {
    std::vector<double> open(turns.begin(), turns.end() - 1);
    const double direction = strain > turns.back() ? 1.0 : -1.0;
    const bool turning = direction * (turns.back() - open.back()) < 0.0;
    if (turning) {
      open.push_back(turns.back());
    }
    while (open.size() > 2 && direction * (strain - open[open.size() - 2]) > 0.0) {
      open.resize(open.size() - 2);
    }
    return shrinking_stress(open, strain);
  };
  double worst = 0.0;
  for (double strain = turns[1]; strain < turns[0]; strain += 1e-6) {
    worst = std::max(worst, std::abs(masing_stress(backbone, history, strain) - exact(strain)));
  }
  EXPECT_LT(worst, bound);
  EXPECT_GT(worst, 0.0);
  // Outside of the loops that were merged nothing is lost.
  const double outside = turns[masing_capacity - 4] * 1.01;
  EXPECT_NEAR(masing_stress(backbone, history, outside), exact(outside), 1e-9 * 50e6 * 2e-3);
}

} // namespace
} // namespace tremolo::materials
