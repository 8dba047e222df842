// MasingShear and IwanShear as laws: simple shear against each other, rotation, initial stress, energy, and
// the same bits however points are grouped.

#include "materials/law/driver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace tremolo::materials {
namespace {

const Elasticity elastic = {1900.0, 130e6, 0.3};
constexpr double gamma_r = 5e-4;

MasingShear masing_law() {
  return {elastic, gamma_r, 1.0, 0.92};
}

IwanShear iwan_law() {
  return iwan_shear(elastic, gamma_r, 1.0, 0.92);
}

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

PointStep shear(double change) {
  return {Control::strain(0.0), Control::strain(0.0), Control::strain(change)};
}

/// How far the polygon lies above and below the backbone at most, relative.
struct Sag {
  double above = 0.0;
  double below = 0.0;
};

Sag sag(const IwanShear& law, const Backbone& backbone) {
  Sag worst;
  for (double strain = 1e-9; strain < 0.1; strain *= 1.001) {
    const double off = monotonic_stress(law, strain) / backbone.stress(strain) - 1.0;
    worst.above = std::max(worst.above, off);
    worst.below = std::max(worst.below, -off);
  }
  return worst;
}

// For a hyperbola sqrt(q) integrates to sqrt(2) pi over all strains, so that e < (sqrt(2) pi/(N - 1))^2/16.
TEST(IwanShear, PolygonIsAsCloseToTheBackboneAsItsSidesAllow) {
  const Backbone hyperbola = {elastic.shear_modulus(), gamma_r, 1.0, 1.0};
  for (const std::size_t elements : {12u, 20u, 32u, 60u}) {
    const IwanShear law = iwan_shear(elastic, gamma_r, 1.0, 1.0, {.elements = elements});
    const double side = std::numbers::sqrt2 * std::numbers::pi / static_cast<double>(elements - 1);
    const Sag worst = sag(law, hyperbola);
    RecordProperty("above_" + std::to_string(elements), std::to_string(worst.above));
    RecordProperty("below_" + std::to_string(elements), std::to_string(worst.below));
    EXPECT_LT(worst.above, side * side / 16.0);
    EXPECT_LT(worst.below, 1.05 * side * side / 16.0); // the spacing is that of many short sides
    double modulus = 0.0;
    for (const IwanElement& element : law.elements) {
      modulus += element.shear_modulus;
    }
    EXPECT_NEAR(modulus / elastic.shear_modulus(), 1.0, 1e-12);
  }
}

TEST(IwanShear, IsLevelBeyondItsLargestStrain) {
  const IwanShear law = iwan_law();
  EXPECT_NEAR(monotonic_stress(law, 0.1) / masing_law().backbone().stress(0.1), 1.0, 2e-3);
  EXPECT_EQ(monotonic_stress(law, 5.0), monotonic_stress(law, 0.1001));
}

/// In simple shear the von Mises bodies are springs with a slider, one after the other.
TEST(IwanShear, IsItsSpringsUnderSimpleShear) {
  const IwanShear law = iwan_law();
  PointTest point(law, {-50e3, -100e3, -50e3, 8e3});
  std::vector<double> springs(law.elements.size(), 0.0);
  std::mt19937_64 random(3);
  double strain = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const double next = std::pow(10.0, between(random, -5.0, -2.0)) * between(random, -1.0, 1.0);
    double sum = 8e3;
    for (std::size_t i = 0; i < springs.size(); ++i) {
      const IwanElement& e = law.elements[i];
      springs[i] = std::clamp(springs[i] + e.shear_modulus * (next - strain), -e.strength, e.strength);
      sum += springs[i];
    }
    point.apply(shear(next - strain));
    strain = next;
    ASSERT_NEAR(point.stress().xy, sum, 1e-10 * 100e3);
    ASSERT_NEAR(point.stress().xx, -50e3, 1e-6);
    ASSERT_NEAR(point.stress().yy, -100e3, 1e-6);
    ASSERT_NEAR(point.stress().zz, -50e3, 1e-6);
  }
}

TEST(MasingShear, IsItsHistoryOnTopOfTheInitialStress) {
  PointTest point(masing_law(), {-50e3, -100e3, -50e3, 8e3});
  std::vector<double> history(masing_history_size, 0.0);
  const MutableMasingHistory view(history.data(), masing_history_size);
  for (const double strain : {1e-3, -4e-4, 6e-4, -2e-3, 1e-5}) {
    point.apply(shear(strain - point.strain().xy));
    masing_commit(masing_law().backbone(), view, strain);
    EXPECT_NEAR(point.stress().xy, 8e3 + history[masing::stress], 1e-9 * 100e3);
    EXPECT_EQ(point.stress().yy, -100e3);
  }
  const PointStress before = point.stress();
  point.apply({Control::strain(1e-4), Control::strain(-3e-4), Control::strain(0.0)});
  const double pressure = elastic.lame() * -2e-4;
  EXPECT_NEAR(point.stress().yy - before.yy, pressure - 2.0 * elastic.shear_modulus() * 3e-4, 1e-6);
  EXPECT_EQ(point.stress().xy, before.xy);
}

/// von Mises bodies in parallel: simple shear along any direction of the plane is the same test.
TEST(IwanShear, IsIsotropicInThePlane) {
  PointTest pure(iwan_law(), {});
  PointTest simple(iwan_law(), {});
  for (const double change : {3e-3, -4e-3, 1e-3, 2e-3}) {
    pure.apply({Control::strain(0.5 * change), Control::strain(-0.5 * change), Control::strain(0.0)});
    simple.apply(shear(change));
    EXPECT_NEAR(pure.stress().xx, simple.stress().xy, 1e-6);
    EXPECT_NEAR(pure.stress().yy, -simple.stress().xy, 1e-6);
  }
}

TEST(HystereticLaws, StressDoesNotDriftFromItsElements) {
  PointTest point(iwan_law(), {-50e3, -100e3, -50e3, 8e3});
  std::mt19937_64 random(5);
  double strain = 0.0;
  for (int k = 0; k < 100000; ++k) {
    const double next = 1e-2 * between(random, -1.0, 1.0);
    point.apply(shear(next - strain));
    strain = next;
  }
  double sum = 8e3;
  for (std::size_t first = 0; first < point.state().size(); first += 3 * iwan_group) {
    for (std::size_t k = 0; k < iwan_group; ++k) {
      sum += point.state()[first + 2 * iwan_group + k];
    }
  }
  EXPECT_NEAR(point.stress().xy, sum, 1e-9 * 100e3);
}

/// Elastic energy + plastic work = trapezoidal work, without remainder.
TEST(HystereticLaws, PlasticWorkClosesTheEnergyBalance) {
  for (const Law& law : {Law(masing_law()), Law(iwan_law())}) {
    PointTest point(law, {-5e3, -9e3, -6e3, 2e3});
    std::mt19937_64 random(6);
    const auto energy = [&] {
      const PointStress s = point.stress();
      return elastic.energy_density(s.xx, s.yy, s.zz, s.xy);
    };
    const double start = energy();
    double work = 0.0;
    double throughput = 0.0;
    for (int k = 0; k < 500; ++k) {
      const PointStress a = point.stress();
      const PointStep step = {Control::strain(1e-3 * between(random, -1.0, 1.0)),
                              Control::strain(1e-3 * between(random, -1.0, 1.0)),
                              Control::strain(4e-3 * between(random, -1.0, 1.0))};
      point.apply(step);
      const PointStress b = point.stress();
      const double done = 0.5 * ((a.xx + b.xx) * step.xx.value() + (a.yy + b.yy) * step.yy.value() +
                                 (a.xy + b.xy) * step.xy.value());
      work += done;
      throughput += std::abs(done);
    }
    EXPECT_NEAR(work, energy() - start + point.plastic_work(), 1e-9 * throughput) << name(law);
    EXPECT_GT(point.plastic_work(), 0.0);
  }
}

TEST(HystereticLaws, AreElasticWhileTheInitialStressIsMade) {
  for (const Law& law : {Law(masing_law()), Law(iwan_law())}) {
    EXPECT_EQ(name(without_softening(law)), "linear_elastic");
    EXPECT_EQ(elasticity(without_softening(law)).young, elastic.young);
  }
}

/// Points that share a block, and their strain increments.
struct Batch {
  explicit Batch(const Law& law, std::size_t count)
      : stress(4 * count, -20e3), state(count * state_variables(law).size(), 0.0), work(count, 0.0),
        strain(4 * count), size(count) {}
  Points points(std::size_t begin, std::size_t count, std::size_t width) {
    return {count,
            &stress[begin],
            &stress[size + begin],
            &stress[2 * size + begin],
            &stress[3 * size + begin],
            state.data() + begin * width,
            &work[begin],
            &strain[begin],
            &strain[size + begin],
            &strain[2 * size + begin],
            &strain[3 * size + begin]};
  }
  std::vector<double> stress, state, work, strain;
  std::size_t size;
};

TEST(HystereticLaws, GiveTheSameBitsHoweverPointsAreGrouped) {
  constexpr std::size_t count = 37;
  for (const Law& law : {Law(masing_law()), Law(iwan_law())}) {
    const std::size_t width = state_variables(law).size();
    Batch together(law, count);
    Batch apart(law, count);
    std::mt19937_64 random(8);
    for (int k = 0; k < 50; ++k) {
      for (std::size_t i = 0; i < together.strain.size(); ++i) {
        together.strain[i] = apart.strain[i] = 2e-3 * between(random, -1.0, 1.0);
      }
      update(law, together.points(0, count, width));
      for (std::size_t begin = 0; begin < count;) {
        const std::size_t part = std::min<std::size_t>(1 + random() % 5, count - begin);
        update(law, apart.points(begin, part, width));
        begin += part;
      }
      ASSERT_EQ(together.stress, apart.stress);
      ASSERT_EQ(together.state, apart.state);
      ASSERT_EQ(together.work, apart.work);
    }
  }
}

} // namespace
} // namespace tremolo::materials
