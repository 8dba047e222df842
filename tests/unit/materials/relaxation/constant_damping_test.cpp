// Constant damping in its band: the ratio against what is wanted, the phase velocity against Kjartansson's
// solid of the same ratio (Kjartansson 1979, J. Geophys. Res. 84, 4737-4748), and numbers of a program
// written apart from this one.

#include "materials/relaxation/constant_damping.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace tremolo::materials {
namespace {

using Complex = std::complex<double>;

Complex at(const Relaxation& soil, double frequency) {
  return soil.factor({0.0, 2.0 * std::numbers::pi * frequency});
}

/// Largest of a measure over the band.
template <class Measure>
double largest_in_band(const DampingBand& band, const Measure& measure) {
  constexpr int points = 2000;
  double largest = 0.0;
  for (int i = 0; i <= points; ++i)
    largest = std::max(largest, measure(band.lowest_hz * std::pow(band.highest_hz / band.lowest_hz,
                                                                  static_cast<double>(i) / points)));
  return largest;
}

struct Wanted {
  DampingBand band;
  double error_of_ratio;
  /// The error of the phase velocity, at ratios of 0.5, 2, 5, 10 and 20 %.
  std::array<double, 5> error_of_velocity;
  std::array<double, 5> unrelaxed; ///< G_U/G at these
};
constexpr std::array ratios = {0.005, 0.02, 0.05, 0.1, 0.2};

void PrintTo(const Wanted& wanted, std::ostream* out) {
  *out << wanted.band.mechanisms << " mechanisms to " << wanted.band.highest_hz << " Hz";
}

class ConstantDampingInItsBand : public testing::TestWithParam<Wanted> {};

TEST_P(ConstantDampingInItsBand, HasTheRatioAndTheVelocity) {
  const DampingBand& band = GetParam().band;
  EXPECT_NEAR(worst_error_of_ratio(band) / GetParam().error_of_ratio, 1.0, 0.02);
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const double ratio = ratios[i];
    const Relaxation soil = relaxation({3.0, band}, ratio);
    const double of_ratio = largest_in_band(band, [&](double f) {
      return std::abs(at(soil, f).imag() / (2.0 * ratio * at(soil, f).real()) - 1.0);
    });
    EXPECT_NEAR(of_ratio, worst_error_of_ratio(band), 1e-6) << ratio;
    const auto phase_velocity = [](Complex modulus) { return 1.0 / (1.0 / std::sqrt(modulus)).real(); };
    const double of_velocity = largest_in_band(band, [&](double f) {
      const Complex kjartansson =
          std::pow(Complex(0.0, f / 3.0), 2.0 * std::atan(2.0 * ratio) / std::numbers::pi);
      return std::abs(phase_velocity(at(soil, f)) / phase_velocity(kjartansson) - 1.0);
    });
    const double wanted = GetParam().error_of_velocity[i];
    EXPECT_NEAR(of_velocity, wanted, std::max(6e-5, 0.025 * wanted)) << ratio; // its digits
    EXPECT_NEAR(soil.unrelaxed(), GetParam().unrelaxed[i], 6e-4) << ratio;
    EXPECT_NEAR(std::abs(at(soil, 3.0)), 1.0, 1e-13) << ratio;
    EXPECT_GT(soil.relaxed, 0.0);
    EXPECT_GT(std::ranges::min(soil.weight), 0.0) << ratio;
  }
}

INSTANTIATE_TEST_SUITE_P(Bands, ConstantDampingInItsBand,
                         testing::Values(Wanted{{0.1, 25.0, 3},
                                                0.055,
                                                {0.0011, 0.0045, 0.0112, 0.022, 0.041},
                                                {1.021, 1.086, 1.229, 1.505, 2.217}},
                                         Wanted{{0.1, 25.0, 4},
                                                0.0132,
                                                {0.0005, 0.0021, 0.0052, 0.0101, 0.0184},
                                                {1.023, 1.096, 1.256, 1.573, 2.411}},
                                         Wanted{{0.1, 25.0, 6},
                                                0.00076,
                                                {0.0002, 0.0008, 0.0020, 0.0039, 0.0071},
                                                {1.026, 1.106, 1.286, 1.647, 2.637}},
                                         Wanted{{0.3, 15.0, 3},
                                                0.0150,
                                                {0.0006, 0.0023, 0.0058, 0.0115, 0.021},
                                                {1.019, 1.080, 1.212, 1.464, 2.102}},
                                         Wanted{{0.3, 15.0, 4},
                                                0.0023,
                                                {0.0003, 0.0011, 0.0027, 0.0053, 0.0097},
                                                {1.021, 1.088, 1.235, 1.520, 2.256}}));

/// M_j/G_U
std::vector<double> shares(const Relaxation& soil) {
  std::vector<double> y = soil.weight;
  for (double& one : y)
    one *= soil.relaxed / soil.unrelaxed();
  return y;
}

TEST(ConstantDamping, HasTheMechanismsOfAnotherProgram) {
  using testing::DoubleNear;
  using testing::ElementsAre;
  const Relaxation four = relaxation({3.0, {0.1, 25.0, 4}}, 0.05);
  EXPECT_THAT(four.time, ElementsAre(DoubleNear(1.51165, 1e-5), DoubleNear(0.22707, 1e-5),
                                     DoubleNear(0.03994, 1e-5), DoubleNear(0.00573, 1e-5)));
  EXPECT_THAT(shares(four), ElementsAre(DoubleNear(0.09712, 1e-5), DoubleNear(0.07991, 1e-5),
                                        DoubleNear(0.08942, 1e-5), DoubleNear(0.14845, 1e-5)));
  const Relaxation three = relaxation({3.0, {0.1, 25.0, 3}}, 0.05);
  EXPECT_THAT(three.time,
              ElementsAre(DoubleNear(1.02422, 1e-5), DoubleNear(0.09355, 1e-5), DoubleNear(0.00827, 1e-5)));
  EXPECT_THAT(shares(three),
              ElementsAre(DoubleNear(0.11609, 1e-5), DoubleNear(0.11372, 1e-5), DoubleNear(0.16594, 1e-5)));
}

TEST(ConstantDamping, OfNoRatioHasNoMechanism) {
  EXPECT_FALSE(relaxation({3.0, {}}, 0.0).acts());
  EXPECT_EQ(relaxation({3.0, {}}, 0.0).factor({0.0, 20.0}), Complex(1.0));
}

TEST(ConstantDamping, OfAVerySmallRatioKeepsItsDigits) {
  const Relaxation soil = relaxation({3.0, {}}, 1e-7);
  EXPECT_NEAR(at(soil, 1.0).imag() / 2e-7, 1.0, 0.014);
}

TEST(ConstantDamping, RefusesWhatIsOutOfRange) {
  const auto refused = [](const ConstantDamping& damping, const std::string& words) {
    EXPECT_THAT([&] { validate(damping); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(words)));
  };
  refused({0.0, {}}, "reference frequency of constant damping is 0");
  refused({3.0, {.lowest_hz = -1.0}}, "lower end of the band of constant damping");
  refused({3.0, {.lowest_hz = 2.0, .highest_hz = 1.0}}, "upper end of the band of constant damping is 1");
  refused({3.0, {.mechanisms = 13}}, "number of mechanisms of constant damping is 13, must be in [1, 12]");
}

} // namespace
} // namespace tremolo::materials
