#include "wavefield/layers/long_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace tremolo::wavefield {
namespace {

/// A minute of shaking that grows and fades and leaves an offset, across the border of two pieces.
Signal shaking() {
  return {[](double t) {
            const double envelope = std::pow(std::sin(std::numbers::pi * (t - 380.0) / 60.0), 4);
            double v = 0.1 * std::exp(-std::pow((t - 405.0) / 2.0, 2));
            for (int k = 1; k < 12; ++k)
              v += std::sin(1.7 * k * std::numbers::sqrt2 * t + k * k) / k;
            return 380.0 < t && t < 440.0 ? envelope * v : 0.0;
          },
          380.0, 440.0, 8.0};
}

LayeredHalfSpace ground(Damping damping, double ratio, double deep_ratio = 0.0) {
  return {.layers = {{.thickness = 20.0, .density = 1700.0, .vs = 120.0, .vp = 400.0, .damping = ratio}},
          .half_space = {2100.0, 500.0, 1000.0},
          .half_space_damping = deep_ratio,
          .damping = damping};
}

constexpr std::array places = {Point{3.0, 0.0}, Point{3.0, -12.0}, Point{3.0, -30.0}};
constexpr TimeGrid times{0.0, 1.0 / 160.0, 140000}; // 875 s

/// Largest difference of a series of the pieces to the whole, over the largest value.
double difference(const LayeredField& field) {
  const auto whole = field.sample(places, times, Part::total, {.displacement = false, .strain = false});
  const LongField pieces(field, places, times, Part::total);
  EXPECT_GT(pieces.pieces().size(), 2U);
  constexpr std::array all{&History::vx,       &History::vy,      &History::sxx,     &History::syy,
                           &History::sxy,      &History::vx_rate, &History::vy_rate, &History::sxx_rate,
                           &History::syy_rate, &History::sxy_rate};
  std::array<double, all.size()> largest{};
  std::array<double, all.size()> wrong{};
  std::size_t first = 0;
  pieces.sample(places, [&](std::size_t number, const std::vector<History>& part) {
    const TimeGrid& piece = pieces.pieces()[number];
    EXPECT_DOUBLE_EQ(piece.start, static_cast<double>(first) * times.dt);
    for (std::size_t p = 0; p < places.size(); ++p)
      for (std::size_t q = 0; q < all.size(); ++q)
        for (std::size_t i = 0; i < piece.count; ++i) {
          const double expected = (whole[p].*all[q])[first + i];
          wrong[q] = std::max(wrong[q], std::abs((part[p].*all[q])[i] - expected));
          largest[q] = std::max(largest[q], std::abs(expected));
        }
    first += piece.count;
  });
  EXPECT_EQ(first, times.count);
  double most = 0.0;
  for (std::size_t q = 0; q < all.size(); ++q)
    most = std::max(most, wrong[q] / largest[q]);
  std::printf("pieces: %.1e\n", most);
  return most;
}

constexpr Incidence oblique{WaveType::SV, 0.3, 0.0, -20.0};

TEST(LongField, IsTheFieldInUndampedLayers) {
  EXPECT_LT(difference({ground({}, 0.0), oblique, 0.0, shaking()}), 1e-9);
}

TEST(LongField, IsTheFieldInViscousLayers) {
  EXPECT_LT(difference({ground({DampingModel::kelvin_voigt, 2.0}, 0.05, 0.01), oblique, 0.0, shaking()}),
            2e-9);
}

TEST(AcceptanceLongField, IsTheFieldWithTheTailsOfConstantDamping) {
  EXPECT_LT(difference({ground({DampingModel::hysteretic, 0.0}, 0.05, 0.01), oblique, 0.0, shaking()}), 1e-8);
}

TEST(AcceptanceLongField, IsTheFieldBeyondTheCriticalAngle) {
  const Incidence beyond{WaveType::SV, 0.7, 0.0, -20.0};
  EXPECT_LT(difference({ground({}, 0.0), beyond, 0.0, shaking()}), 1e-8);
}

TEST(AcceptanceLongField, IsTheFieldInKjartanssonDamping) {
  EXPECT_LT(difference({ground({DampingModel::kjartansson, 1.0}, 0.05), oblique, 0.0, shaking()}), 1e-7);
}

TEST(LongField, FewTimesStayWhole) {
  const LayeredField field(ground({}, 0.0), oblique, 0.0, shaking());
  EXPECT_EQ(LongField(field, places, {0.0, 0.01, 100000}, Part::total).pieces().size(), 1U);
}

} // namespace
} // namespace tremolo::wavefield
