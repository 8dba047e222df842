// Random strain histories: the stress stays inside the backbone of the largest strain, closed loops return to
// their point, and a second, independent model - many elastoplastic springs in parallel, which obey the
// Masing rules without knowing them - gives the same stress within the error of its polygon.

#include "materials/hysteretic/iwan_shear.hpp"
#include "materials/hysteretic/masing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace tremolo::materials {
namespace {

constexpr Backbone backbone = {45e6, 5e-4, 1.0, 0.92};
using History = std::array<double, masing_history_size>;

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A strain turning at random points, small and large.
double next_strain(std::mt19937_64& random) {
  const double size = std::pow(10.0, between(random, -6.0, -2.0));
  return size * between(random, -1.0, 1.0);
}

TEST(RandomMasingPaths, StayInsideTheBackboneOfTheLargestStrain) {
  std::mt19937_64 random(11);
  for (int path = 0; path < 200; ++path) {
    History history{};
    double largest = 0.0;
    for (int k = 0; k < 2000; ++k) {
      const double strain = next_strain(random);
      largest = std::max(largest, std::abs(strain));
      masing_commit(backbone, history, strain);
      ASSERT_LE(std::abs(history[masing::stress]), backbone.stress(largest) * (1.0 + 1e-12));
    }
  }
}

TEST(RandomMasingPaths, ClosedInnerLoopsReturnToTheSamePoint) {
  std::mt19937_64 random(12);
  for (int path = 0; path < 2000; ++path) {
    History history{};
    for (int k = 0; k < 6; ++k) {
      masing_commit(backbone, history, next_strain(random));
    }
    const History before = history;
    const double here = history[masing::strain];
    // Away from here against the last direction, wandering inside [here, here + reach], and back.
    const double reach = (masing_reverses(history, here + 1e-9) ? 1.0 : -1.0) * 1e-7;
    masing_commit(backbone, history, here + reach);
    for (int k = 0; k < 10; ++k) {
      masing_commit(backbone, history, here + reach * between(random, 0.01, 1.0));
    }
    masing_commit(backbone, history, here);
    const double on = here - 1e-3 * reach;
    EXPECT_NEAR(history[masing::stress], before[masing::stress], 1e-9 * backbone.stress(1e-2));
    EXPECT_NEAR(masing_stress(backbone, history, on), masing_stress(backbone, before, on),
                1e-9 * backbone.stress(1e-2));
  }
}

/// Springs in parallel in one dimension: force k_i times strain, limited to tau_i.
class Springs {
public:
  explicit Springs(const IwanShear& law) : law_(law), stress_(law.elements.size(), 0.0) {}
  double move(double change) {
    double sum = 0.0;
    for (std::size_t i = 0; i < stress_.size(); ++i) {
      const IwanElement& element = law_.elements[i];
      stress_[i] =
          std::clamp(stress_[i] + element.shear_modulus * change, -element.strength, element.strength);
      sum += stress_[i];
    }
    return sum;
  }

private:
  const IwanShear& law_;
  std::vector<double> stress_;
};

IwanShear law_of(std::size_t elements) {
  const Elasticity elastic = {1800.0, 2.6 * backbone.shear_modulus, 0.3};
  return iwan_shear(elastic, backbone.reference_strain, backbone.beta, backbone.exponent,
                    {.elements = elements, .largest_strain = 0.1});
}

/// Largest relative distance of the springs' polygon from the backbone.
double polygon_error(const IwanShear& law) {
  double worst = 0.0;
  for (double strain = 1e-9; strain < 0.1; strain *= 1.001) {
    worst = std::max(worst, std::abs(monotonic_stress(law, strain) / backbone.stress(strain) - 1.0));
  }
  return worst;
}

/// Stress changes from the start over all open reversal points to the present, all positive.
double path_of_stress(const History& history) {
  double sum = 0.0;
  double from = 0.0;
  const auto points = static_cast<std::size_t>(history[masing::reversals]);
  for (std::size_t i = 0; i < points; ++i) {
    const double to = history[masing::first_point + 2 * i + 1];
    sum += std::abs(to - from);
    from = to;
  }
  return sum + std::abs(history[masing::stress] - from);
}

/// Largest difference between rules and springs over random cycles, relative to the backbone's stress at the
/// largest strain so far. Every piece of the path is a (doubled) backbone, which the springs follow within
/// the error of their polygon: the difference is bounded by that error times the whole path.
double difference(std::size_t elements) {
  const IwanShear law = law_of(elements);
  const double error = polygon_error(law);
  std::mt19937_64 random(13);
  double worst = 0.0;
  for (int path = 0; path < 50; ++path) {
    History history{};
    Springs springs(law);
    double largest = 0.0;
    for (int k = 0; k < 400; ++k) {
      const double strain = next_strain(random);
      largest = std::max(largest, std::abs(strain));
      const double other = springs.move(strain - history[masing::strain]);
      masing_commit(backbone, history, strain);
      const double off = std::abs(history[masing::stress] - other);
      EXPECT_LE(off, 1.001 * error * path_of_stress(history)); // the scan may miss the very peak
      worst = std::max(worst, off / backbone.stress(largest));
    }
  }
  return worst;
}

TEST(RandomMasingPaths, AreThoseOfParallelSprings) {
  const double e12 = difference(12);
  const double e20 = difference(20);
  const double e32 = difference(32);
  const double e60 = difference(60);
  RecordProperty("elements_12", std::to_string(e12));
  RecordProperty("elements_20", std::to_string(e20));
  RecordProperty("elements_32", std::to_string(e32));
  RecordProperty("elements_60", std::to_string(e60));
  // The polygon errs at order 2 in its sides but for the small strains that it reaches further into as it
  // gets finer; the worst point of a random path scatters. Between order 1 and 2 this decides.
  EXPECT_GT(std::log(e12 / e60) / std::log(59.0 / 11.0), 1.5);
  EXPECT_GT(e12, e20);
  EXPECT_GT(e20, e32);
  EXPECT_GT(e32, e60);
}

} // namespace
} // namespace tremolo::materials
