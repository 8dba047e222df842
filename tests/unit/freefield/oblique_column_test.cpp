#include "freefield/oblique/oblique_column.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>

namespace {

using namespace tremolo::freefield;
using testing::HasSubstr;
using tremolo::materials::Elasticity;

Profile profile() {
  return {.layers = {{10.0, Elasticity::from_wave_speeds(1800.0, 200.0, 1500.0)}},
          .half_space = Elasticity::from_wave_speeds(2200.0, 600.0, 1200.0)};
}

std::string refusal(const Profile& soil, const ObliqueColumnSettings& settings) {
  try {
    const ObliqueColumn column(soil, settings, [](double) { return Velocity{}; });
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(ObliqueColumn, StatesTheLimitingAngleOfTheFastestLayer) {
  // asin(600/1500) = 23.578 degrees for SV, asin(1200/1500) = 53.13 for P
  const auto text = refusal(profile(), {.max_cell_size = 1.0, .time_step = 1e-4, .slowness_x = 0.41 / 600.0});
  EXPECT_THAT(text, HasSubstr("layer 1 from the top"));
  EXPECT_THAT(text, HasSubstr("SV waves below 23.578"));
  EXPECT_THAT(text, HasSubstr("P waves below 53.13"));
  EXPECT_EQ(refusal(profile(), {.max_cell_size = 1.0, .time_step = 1e-4, .slowness_x = 0.39 / 600.0}), "");
}

TEST(ObliqueColumn, StatesTheStepLimit) {
  const double p = 0.2 / 600.0;
  const double limit = std::sqrt(1.0 / (1500.0 * 1500.0) - p * p);
  EXPECT_NEAR(oblique_step_limit(profile(), 1.0, p), limit, 1e-15);
  EXPECT_THAT(refusal(profile(), {.max_cell_size = 1.0, .time_step = 1.01 * limit, .slowness_x = p}),
              HasSubstr("stability limit"));
}

TEST(ObliqueColumn, RefusesDampedLayersAndOtherLaws) {
  Profile damped = profile();
  damped.layers[0].damping_ratio = 0.02;
  EXPECT_THAT(refusal(damped, {.max_cell_size = 1.0, .time_step = 1e-4}), HasSubstr("ill posed"));
  Profile frictional = profile();
  tremolo::materials::MohrCoulomb law;
  law.elastic = frictional.layers[0].soil;
  law.cohesion_peak = law.cohesion_residual = 1e4;
  frictional.layers = {layer_of(10.0, law)};
  EXPECT_THAT(refusal(frictional, {.max_cell_size = 1.0, .time_step = 1e-4}), HasSubstr("`fe`"));
}

} // namespace
