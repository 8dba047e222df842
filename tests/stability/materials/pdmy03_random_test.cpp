// A million random increments of strain and rotation, in plane strain and out of it, from initial stresses
// with K_0 = 0.3 to 2 and 1 kPa to 2 MPa, at all densities and cones: the stress is a number inside the
// failure cone and plastic work is bounded by what stress and strain can do.

#include "pdmy03_bounds.hpp"

#include <rapidcheck.h>

#include <array>
#include <vector>

namespace tremolo::materials::test {
namespace {

/// A number in [low, high], whatever size rapidcheck asks for.
rc::Gen<double> number(double low, double high) {
  constexpr int grains = 1000000;
  return rc::gen::resize(rc::kNominalSize, rc::gen::map(rc::gen::inRange(0, grains + 1), [=](int k) {
                           return low + (high - low) * k / grains;
                         }));
}

/// Shares of xx, yy, zz, xy; decimal logarithm of their size; rotation, rad.
using Leg = std::array<double, 6>;

std::vector<Leg> random_legs(std::size_t count, double largest) {
  const auto one = number(-1.0, 1.0);
  return *rc::gen::container<std::vector<Leg>>(
      count, rc::gen::map(rc::gen::tuple(one, one, one, one, number(-12.0, largest), number(-0.5, 0.5)),
                          [](const auto& t) { return std::apply([](auto... x) { return Leg{x...}; }, t); }));
}

Pdmy03 random_sand() {
  Pdmy03Input input;
  input.relative_density = densities[*rc::gen::inRange(0, 4)];
  input.cone = std::array{Pdmy03Cone::triaxial_compression, Pdmy03Cone::triaxial_extension,
                          Pdmy03Cone::plane_strain}[static_cast<std::size_t>(*rc::gen::inRange(0, 3))];
  input.liquefaction_1 = static_cast<double>(*rc::gen::inRange(0, 2));
  input.liquefaction_2 = static_cast<double>(*rc::gen::inRange(0, 2));
  return pdmy03(input);
}

PointStress random_stress() {
  const double vertical = std::pow(10.0, *number(3.0, std::log10(2e6)));
  const double lateral = *number(0.3, 2.0) * vertical;
  return {-lateral, -vertical, -lateral, *number(-0.3, 0.3) * vertical};
}

/// The work that the larger of two stresses does on a strain and on the elastic strain it releases, J/m3.
double largest_work(const Pdmy03& law, const PointStress& a, const PointStress& b, const Leg& leg) {
  const auto size = [&](const PointStress& s) {
    return shear_measure(s) + law.residual_pressure - mean_stress(s);
  };
  const double stress = std::max(size(a), size(b));
  const double least = law.residual_pressure - std::max(mean_stress(a), mean_stress(b));
  const double factor = std::sqrt(least / (law.reference_pressure + law.residual_pressure));
  const double strain = std::pow(10.0, leg[4]) * std::sqrt(3.5);
  return stress * (strain + stress / (factor * law.elastic.shear_modulus()));
}

/// Up to steps of this size the stress between the ends of a step is not more than at the larger of them; in
/// larger ones, of thousands of sub-increments, it may rise and fall, and their work is only a number.
constexpr double bounded_work = 1e-3;

void walk(std::size_t legs, int repeats, double largest) {
  const Pdmy03 law = random_sand();
  PointTest point(law, random_stress());
  for (const Leg& leg : random_legs(legs, largest)) {
    const double size = std::pow(10.0, leg[4]);
    PointStep step = {Control::strain(size * leg[0]), Control::strain(size * leg[1]),
                      Control::strain(size * leg[3]), leg[5], Control::strain(size * leg[2])};
    for (int k = 0; k < repeats; ++k) {
      const PointStress before = point.stress();
      const double work = point.plastic_work();
      point.apply(step);
      RC_ASSERT(held(law, point.stress()));
      RC_ASSERT(std::isfinite(point.plastic_work()));
      RC_ASSERT(size > bounded_work ||
                std::abs(point.plastic_work() - work) <= largest_work(law, before, point.stress(), leg));
      RC_ASSERT(state_of(point).gap >= 0.0);
    }
  }
}

TEST(Pdmy03Random, AMillionIncrementsUpToOnePerMille) {
  EXPECT_TRUE(rc::check([] { walk(100, 100, -3.0); })); // of 100 cases
}

TEST(Pdmy03Random, ManyThousandIncrementsUpToTheLargest) {
  EXPECT_TRUE(rc::check([] { walk(20, 5, std::log10(pdmy03_largest_increment)); }));
}

} // namespace
} // namespace tremolo::materials::test
