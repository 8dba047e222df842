// Toro's profiles: correlations by hand, and the statistics of many realisations. Bounds are four standard
// deviations of what is estimated, worked out beside it.

#include "scene/random/random_profile.hpp"
#include "scene/random/toro.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace tremolo::scene {
namespace {

constexpr double deviations = 4.0;
constexpr double unlimited = std::numeric_limits<double>::infinity();

using Realisation = std::vector<double>;

std::vector<Realisation> realisations(const ToroModel& model, const std::vector<double>& middles,
                                      double limit, std::size_t count) {
  std::vector<Realisation> all;
  for (std::size_t i = 0; i < count; ++i)
    all.push_back(standard_variates(model, middles, limit, NormalVariates{std::mt19937_64(i)}));
  return all;
}

template <class Of>
double mean(const std::vector<Realisation>& all, const Of& of) {
  double sum = 0.0;
  for (const Realisation& one : all)
    sum += of(one);
  return sum / static_cast<double>(all.size());
}

TEST(Toro, CorrelationsAreThoseComputedByHand) {
  const ToroModel usgs_c = toro_model(ToroClass::usgs_c);
  EXPECT_NEAR(0.4745130729579, correlation(usgs_c, 2.5, 7.5), 1e-12);
  EXPECT_NEAR(0.9815243672007, correlation(usgs_c, 250.0, 260.0), 1e-12); // of depth no more below 200 m
  EXPECT_NEAR(0.0345011466024, correlation(toro_model(ToroClass::usgs_d), 5.0, 6.0), 1e-12);
  EXPECT_NEAR(0.8112936683026, correlation({0.3, 0.9, 6.0, 0.8, 3.0, 0.2}, 10.0, 12.0), 1e-12);
}

TEST(Toro, LayersAtOnePlaceAreOneAndFarOnesGoWithDepthAlone) {
  const ToroModel model{.sigma_ln = 0.3, .rho_0 = 1.0, .delta = 2.0, .rho_200 = 0.7, .h_0 = 0.0, .b = 0.5};
  EXPECT_DOUBLE_EQ(1.0, correlation(model, 10.0, 10.0));
  EXPECT_NEAR(0.7 * std::sqrt(50.0 / 200.0), correlation(model, 0.0, 100.0), 1e-12);
}

TEST(Toro, VariatesWithoutALimitAreNormalAndCorrelatedAsTheModelSays) {
  const ToroModel model = toro_model(ToroClass::usgs_c);
  const std::vector<double> middles = {1.0, 3.0, 6.5, 15.0, 30.0};
  constexpr std::size_t count = 40000;
  const auto all = realisations(model, middles, unlimited, count);
  const double root = std::sqrt(static_cast<double>(count));
  for (std::size_t i = 0; i < middles.size(); ++i) {
    EXPECT_LT(std::abs(mean(all, [&](const auto& z) { return z[i]; })), deviations / root);
    EXPECT_LT(std::abs(mean(all, [&](const auto& z) { return z[i] * z[i]; }) - 1.0),
              deviations * std::sqrt(2.0) / root);
    if (i == 0)
      continue;
    // The variance of a product of standard normal variates is 1 + rho^2.
    const double rho = correlation(model, middles[i - 1], middles[i]);
    EXPECT_LT(std::abs(mean(all, [&](const auto& z) { return z[i - 1] * z[i]; }) - rho),
              deviations * std::sqrt(1.0 + rho * rho) / root);
  }
  // Layers further apart are correlated through those between them.
  const double through = correlation(model, 1.0, 3.0) * correlation(model, 3.0, 6.5);
  EXPECT_LT(std::abs(mean(all, [](const auto& z) { return z[0] * z[2]; }) - through),
            deviations * std::sqrt(1.0 + through * through) / root);
}

double normal_density(double z) {
  return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
}

/// The chain of draws within a limit on a grid of midpoints: z_i given z_(i-1) has the normal density about
/// rho z_(i-1) with the variance 1 - rho^2, divided by its share within the limit.
class LimitedChain {
public:
  explicit LimitedChain(double limit) : step_(2.0 * limit / points), z_(points), density_(points) {
    for (std::size_t k = 0; k < points; ++k) {
      z_[k] = -limit + (static_cast<double>(k) + 0.5) * step_;
      density_[k] = normal_density(z_[k]);
    }
    normalise(density_);
  }

  /// Moment of the present layer.
  template <class Of>
  double moment(const Of& of) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < points; ++k)
      sum += density_[k] * of(z_[k]);
    return step_ * sum;
  }

  /// Goes to the next layer; moments of the product of both, first and second.
  std::pair<double, double> next(double rho) {
    const double rest = std::sqrt(1.0 - rho * rho);
    std::vector<double> after(points);
    double first = 0.0;
    double second = 0.0;
    for (std::size_t k = 0; k < points; ++k) {
      std::vector<double> given(points);
      for (std::size_t j = 0; j < points; ++j)
        given[j] = normal_density((z_[j] - rho * z_[k]) / rest);
      normalise(given);
      for (std::size_t j = 0; j < points; ++j) {
        const double weight = step_ * density_[k] * given[j];
        after[j] += weight;
        first += step_ * weight * z_[k] * z_[j];
        second += step_ * weight * z_[k] * z_[j] * z_[k] * z_[j];
      }
    }
    density_ = after;
    return {first, second};
  }

private:
  static constexpr std::size_t points = 400;

  void normalise(std::vector<double>& density) const {
    double sum = 0.0;
    for (const double value : density)
      sum += step_ * value;
    for (double& value : density)
      value /= sum;
  }

  double step_;
  std::vector<double> z_;
  std::vector<double> density_;
};

TEST(Toro, VariatesWithinALimitHaveTheMomentsOfTheirChain) {
  const ToroModel model = toro_model(ToroClass::usgs_c);
  const std::vector<double> middles = {1.0, 3.0, 6.5, 15.0};
  constexpr std::size_t count = 40000;
  const auto all = realisations(model, middles, most_deviations, count);
  LimitedChain chain(most_deviations);
  const auto near = [&](double found, double expected, double variance) {
    EXPECT_LT(std::abs(found - expected), deviations * std::sqrt(variance / static_cast<double>(count)))
        << found << " for " << expected;
  };
  for (std::size_t i = 0; i < middles.size(); ++i) {
    if (i > 0) {
      const auto [first, second] = chain.next(correlation(model, middles[i - 1], middles[i]));
      near(mean(all, [&](const auto& z) { return z[i - 1] * z[i]; }), first, second - first * first);
    }
    const double variance = chain.moment([](double z) { return z * z; });
    const double fourth = chain.moment([](double z) { return z * z * z * z; });
    near(mean(all, [&](const auto& z) { return z[i]; }), 0.0, variance);
    near(mean(all, [&](const auto& z) { return z[i] * z[i]; }), variance, fourth - variance * variance);
    // The normal distribution cut at two deviations has 0.88 of its standard deviation; the chain's a little
    // less.
    EXPECT_NEAR(0.88, std::sqrt(variance), 0.02);
  }
  for (const Realisation& one : all)
    for (const double z : one)
      ASSERT_LE(std::abs(z), most_deviations);
}

RandomProfile realised(std::uint32_t seed, std::uint32_t realisation, const std::vector<double>& thicknesses,
                       double layer_thickness = 5.0) {
  RandomProfile profile{.model = toro_model(ToroClass::usgs_c),
                        .layer_thickness = layer_thickness,
                        .seed = seed,
                        .realisation = realisation,
                        .layers = {}};
  realise(profile, 2.0, thicknesses);
  return profile;
}

TEST(Toro, ThickLayersAreCutIntoEqualParts) {
  const auto profile = realised(1, 1, {4.0, 12.0, 5.0});
  ASSERT_EQ(5U, profile.layers.size());
  const std::vector<double> bottoms = {-2.0, -6.0, -10.0, -14.0, -19.0};
  for (std::size_t i = 0; i < bottoms.size(); ++i) {
    EXPECT_NEAR(bottoms[i], profile.layers[i].bottom, 1e-12);
    EXPECT_NEAR(i == 0 ? 2.0 : bottoms[i - 1], profile.layers[i].top, 1e-12);
  }
}

TEST(Toro, EveryLevelHasTheFactorOfItsLayer) {
  const auto profile = realised(1, 1, {4.0, 12.0});
  EXPECT_EQ(profile.layers[0].factor, profile.factor_at(10.0)); // above the surface
  EXPECT_EQ(profile.layers[0].factor, profile.factor_at(-1.9));
  EXPECT_EQ(profile.layers[1].factor, profile.factor_at(-2.1));
  EXPECT_EQ(profile.layers[3].factor, profile.factor_at(-13.9));
  EXPECT_EQ(1.0, profile.factor_at(-14.1)); // half-space
  EXPECT_EQ((std::vector<double>{-6.0, -10.0}), profile.interfaces(-2.0, -13.0));
}

TEST(Toro, SeedAndRealisationDecide) {
  const auto factors = [](const RandomProfile& profile) {
    std::vector<double> all;
    for (const RandomLayer& layer : profile.layers)
      all.push_back(layer.factor);
    return all;
  };
  const auto one = factors(realised(1, 1, {20.0}));
  EXPECT_EQ(one, factors(realised(1, 1, {20.0})));
  EXPECT_NE(one, factors(realised(1, 2, {20.0})));
  EXPECT_NE(one, factors(realised(2, 1, {20.0})));
}

TEST(Toro, RealisationsOfOneSeedAreIndependent) {
  constexpr std::uint32_t count = 4000;
  double sum = 0.0;
  double before = 0.0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double z = std::log(realised(1, i, {5.0}).layers.front().factor) / 0.31;
    sum += z * before;
    before = z;
  }
  EXPECT_LT(std::abs(sum / count), deviations / std::sqrt(count)); // variance of the products below 1
}

} // namespace
} // namespace tremolo::scene
