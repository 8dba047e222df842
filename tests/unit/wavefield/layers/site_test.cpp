#include "wavefield/layers/site.hpp"

#include "wavefield/layers/transfer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace tremolo::wavefield {
namespace {

LayeredHalfSpace on_rock(std::vector<Layer> layers) {
  return {.layers = std::move(layers), .half_space = {.density = 2200.0, .vs = 760.0, .vp = 1500.0}};
}

TEST(Site, MeanSpeedIsDepthOverTravelTime) {
  const auto profile = on_rock({{5.0, 1700.0, 125.0, 300.0}, {10.0, 1900.0, 250.0, 500.0}});
  EXPECT_NEAR(mean_shear_speed(profile, 4.0), 125.0, 1e-12);
  EXPECT_NEAR(mean_shear_speed(profile, 10.0), 10.0 / (0.04 + 0.02), 1e-12);
  EXPECT_NEAR(mean_shear_speed(profile, 30.0), 30.0 / (0.04 + 0.04 + 15.0 / 760.0), 1e-12);
  EXPECT_THROW(mean_shear_speed(profile, 0.0), std::invalid_argument);
}

TEST(Site, OneLayerHasFourTravelTimes) {
  EXPECT_NEAR(fundamental_period(on_rock({{20.0, 1800.0, 200.0, 400.0}})), 4.0 * 20.0 / 200.0, 1e-12);
}

TEST(Site, IdenticalLayersAreOne) {
  EXPECT_NEAR(fundamental_period(on_rock(std::vector<Layer>(8, {2.5, 1800.0, 200.0, 400.0}))), 0.4, 1e-12);
}

TEST(Site, TwoLayersAsMadera) {
  // tan(w h1/v1) tan(w h2/v2) = rho2 v2/(rho1 v1) (Madera 1970, Fundamental period and amplification of peak
  // acceleration in layered systems, MIT R70-37).
  for (const double ratio : {0.2, 0.7, 3.0, 12.0}) {
    const Layer upper{8.0, 1700.0, 150.0, 400.0};
    const Layer lower{12.0, 1900.0, 150.0 * ratio, 150.0 * ratio * 3.0};
    const double w = 2.0 * std::numbers::pi / fundamental_period(on_rock({upper, lower}));
    EXPECT_NEAR(std::tan(w * upper.thickness / upper.vs) * std::tan(w * lower.thickness / lower.vs),
                lower.density * lower.vs / (upper.density * upper.vs), 1e-9 * (1.0 + ratio))
        << ratio;
  }
}

TEST(Site, ManyLayersResonateWhereTheirTransferFunctionDoes) {
  // Surface over base of hardly damped layers peaks at the first mode on a rigid base.
  auto profile = on_rock({{3.0, 1600.0, 110.0, 300.0},
                          {4.0, 1900.0, 320.0, 700.0},
                          {9.0, 1700.0, 180.0, 400.0},
                          {14.0, 2000.0, 400.0, 900.0}});
  for (Layer& layer : profile.layers)
    layer.damping = 1e-4;
  profile.damping.model = DampingModel::hysteretic;
  std::vector<double> frequencies;
  for (double f = 1.0; f < 4.0; f += 5e-4)
    frequencies.push_back(f);
  const auto found = surface_transfer(profile, WaveType::SV, 0.0, frequencies);
  const auto peak =
      std::ranges::max_element(found, {}, [](const SurfaceTransfer& one) { return std::abs(one.to_within); });
  EXPECT_NEAR(1.0 / fundamental_period(profile), peak->frequency_hz, 5e-4);
}

TEST(Site, ImpedanceContrastIsThatOfWhatLiesBelow) {
  const auto profile = on_rock({{5.0, 1700.0, 125.0, 300.0}, {10.0, 1900.0, 250.0, 500.0}});
  EXPECT_DOUBLE_EQ(impedance_contrast(profile, 0), 1900.0 * 250.0 / (1700.0 * 125.0));
  EXPECT_DOUBLE_EQ(impedance_contrast(profile, 1), 2200.0 * 760.0 / (1900.0 * 250.0));
  EXPECT_THROW(fundamental_period(on_rock({})), std::invalid_argument);
}

} // namespace
} // namespace tremolo::wavefield
