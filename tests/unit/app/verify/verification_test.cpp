// Runs that depart from the exact field by a known amount: the verification finds that amount.

#include "app/verify/verification.hpp"

#include "tests/support/exact_run.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <map>
#include <stdexcept>

namespace {

using namespace tremolo;
using namespace tremolo::testing;
using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

app::Verification verification_of(const Departure& departure, const std::string& case_text = exact_case) {
  const TemporaryFolder folder;
  write_exact_run(folder / "run.h5", departure, case_text);
  const results::RunReader run(folder / "run.h5");
  return app::verify(run, scene::parse(run.case_text(), "case.toml", "."));
}

std::map<std::string, app::Agreement> by_name(const app::Verification& verification) {
  std::map<std::string, app::Agreement> regions;
  for (const app::Agreement& region : verification.particles.regions)
    regions[region.name] = region;
  return regions;
}

/// What the interpolation of the exact field may add.
constexpr double interpolation = 1e-7;

TEST(Verification, FindsNoErrorInTheExactField) {
  for (const auto& [name, region] : by_name(verification_of({}))) {
    EXPECT_LT(region.relative_l2, interpolation) << name;
    EXPECT_LT(region.peak_error, interpolation) << name;
    EXPECT_NEAR(region.phase_lag, 0.0, 1e-9) << name;
  }
}

TEST(Verification, FindsAFactorOnAllVelocities) {
  const auto verification = verification_of({.factor = [](double, double) { return 1.02; }});
  for (const auto& [name, region] : by_name(verification)) {
    EXPECT_NEAR(region.relative_l2, 0.02, interpolation) << name;
    EXPECT_NEAR(region.peak_error, 0.02, interpolation) << name;
    EXPECT_NEAR(region.phase_lag, 0.0, 2e-5) << name;
  }
}

TEST(Verification, FindsADelay) {
  for (const double delay : {0.002, -0.0005, 0.03})
    for (const auto& [name, region] : by_name(verification_of({.delay = delay})))
      EXPECT_NEAR(region.phase_lag, delay, 1e-7) << name;
}

// Regions: 2.5 m (a quarter of 10 m) from sides and base.
TEST(Verification, FindsWhereTheErrorIs) {
  const auto side_only = [](double x, double y) { return x < 2.5 && y > -7.5 ? 1.1 : 1.0; };
  const auto verification = verification_of({.factor = side_only});
  EXPECT_EQ(verification.particles.boundary_width, 2.5);
  const auto regions = by_name(verification);
  EXPECT_EQ(regions.at("whole").particles, 800);
  EXPECT_EQ(regions.at("interior").particles, 30 * 15);
  EXPECT_EQ(regions.at("near sides").particles, 10 * 20);
  EXPECT_EQ(regions.at("near base").particles, 40 * 5);
  EXPECT_LT(regions.at("interior").relative_l2, interpolation);
  EXPECT_LT(regions.at("near base").relative_l2, interpolation);
  EXPECT_GT(regions.at("near sides").relative_l2, 0.03);

  // The rms of the particles' errors is the error of the whole.
  double mean_square = 0.0;
  for (std::size_t i = 0; i < 800; ++i) {
    const double error = verification.particles.relative_error[i];
    const bool wrong = side_only(verification.particles.x[i], verification.particles.y[i]) != 1.0;
    EXPECT_EQ(error > 1e-3, wrong) << i;
    mean_square += error * error / 800.0;
  }
  EXPECT_NEAR(std::sqrt(mean_square), regions.at("whole").relative_l2, 1e-9);
}

TEST(Verification, HoldsMonitorsAgainstTheExactField) {
  const auto verification = verification_of({});
  ASSERT_EQ(verification.points.size(), 1);
  const app::PointHistory& centre = verification.points.front();
  EXPECT_EQ(centre.name, "centre");
  EXPECT_NEAR(centre.x, 10.25, 1e-12);
  EXPECT_NEAR(centre.y, -4.75, 1e-12);
  EXPECT_THAT(centre.exact_vx, ::testing::Pointwise(DoubleNear(1e-8), centre.vx));
  EXPECT_THAT(centre.exact_vy, ::testing::Pointwise(DoubleNear(1e-8), centre.vy));
}

TEST(Verification, TakesParticlesWhereThereAreNoMonitors) {
  const auto verification = verification_of({.monitor = false});
  ASSERT_EQ(verification.points.size(), 3);
  EXPECT_EQ(verification.points[0].name, "surface");
  EXPECT_EQ(verification.points[0].y, -0.25);
  EXPECT_EQ(verification.points[2].y, -9.75);
  for (const app::PointHistory& point : verification.points)
    EXPECT_THAT(point.exact_vx, ::testing::Pointwise(DoubleNear(1e-8), point.vx)) << point.name;
}

TEST(Verification, ReportsTheResidualOfTheEnergyLedger) {
  EXPECT_THAT(verification_of({}).energy_residual, ::testing::Optional(exact_run_energy_residual / 100.0));
}

TEST(Verification, WorksBeyondTheCriticalAngle) {
  const auto text = exact_case_with("angle_deg = 15.0", "angle_deg = 40.0");
  const auto regions =
      by_name(verification_of({.factor = [](double, double) { return 1.02; }, .monitor = false}, text));
  EXPECT_NEAR(regions.at("whole").relative_l2, 0.02, 1e-6);
}

TEST(Verification, RefusesWhatCannotBeCompared) {
  const auto refuses = [](const Departure& departure, const std::string& text, const std::string& message) {
    EXPECT_THAT([&] { verification_of(departure, text); },
                ThrowsMessage<std::runtime_error>(HasSubstr(message)));
  };
  refuses({.finished = false}, exact_case, "only a complete run can be verified, this one is running");
  refuses({.factor = [](double x, double) { return x < 0.5 ? NAN : 1.0; }}, exact_case,
          "the velocity of particle 0 at t = 0 s is nan: the run is unstable");
  refuses({}, exact_case_with("time = 0.6", "time = 9.0"), "there is nothing to compare");
  refuses({}, exact_case_with("young = 40e6\npoisson = 0.28\n[soil", "young = 50e6\npoisson = 0.28\n[soil"),
          "the exact field of this case is not known: soil 'sand'");
}

} // namespace
