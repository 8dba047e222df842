// What the user of a case reads of an equivalent-linear iteration: depths in metres, though layers were cut,
// and the name of the case file and of the key where it does not converge.

#include "scene/case.hpp"
#include "scene/plan/plan.hpp"
#include "wavefield/process/field_from_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace {

using namespace tremolo;

std::string clay_case(const std::string& velocity, const std::string& numerics) {
  return R"(title = "clay"
[motion]
wave = "SV"
angle_deg = 0
reference = [0, -8]
pulse = { shape = "ricker", frequency = 2.0, time = 0.8, velocity = )" +
         velocity + R"( }
[surface]
level = 0.0
[halfspace]
density = 2000.0
vs = 400.0
vp = 800.0
[[profile]]
thickness = 8.0
soil = "clay"
[damping]
model = "hysteretic"
[soil.clay]
model = "hyperbolic"
density = 1700.0
young = 80e6
poisson = 0.3
reference_strain = 2e-4
[[region]]
soil = "clay"
polygon = [[0.0, -8.0], [10.0, -8.0], [10.0, 0.0], [0.0, 0.0]]
[mesh]
size = 1.0
box = [0.0, -8.0, 10.0, 0.0]
[boundary]
left = { model = "eql" }
right = { model = "eql" }
base = { model = "eql" }
[[stage]]
kind = "shaking"
duration_s = 1.0
[eql]
)" + numerics;
}

wavefield::EquivalentLinearResult iterated(const std::string& text) {
  const scene::Case scene = scene::parse(text, "clay.toml", ".");
  return wavefield::equivalent_linear_from_case(scene, scene::plan(scene).sources.front());
}

TEST(EquivalentLinearCase, NamesFileKeyAndDepthWhereItDoesNotConverge) {
  EXPECT_THAT(
      [] { iterated(clay_case("0.1", "iterations = 2")); },
      ::testing::ThrowsMessage<std::runtime_error>(::testing::AllOf(
          ::testing::StartsWith("clay.toml: the equivalent linear analysis has not converged after 2"),
          ::testing::HasSubstr(" m below the surface; allowed is 0.1 %"),
          ::testing::EndsWith("`[eql] unconverged = \"allow\"` takes the last step as it is"))));
  EXPECT_FALSE(iterated(clay_case("0.1", "iterations = 2\nunconverged = \"allow\"")).converged);
}

TEST(EquivalentLinearCase, SummarySaysWhereDampingIsHeld) {
  EXPECT_THAT(
      wavefield::summary(iterated(clay_case("0.01", ""))),
      ::testing::AllOf(::testing::StartsWith("converged"), ::testing::Not(::testing::HasSubstr("held"))));
  const auto strong = iterated(clay_case("1.0", "unconverged = \"allow\""));
  ASSERT_FALSE(strong.held_damping.empty());
  EXPECT_THAT(wavefield::summary(strong),
              ::testing::AllOf(::testing::HasSubstr("damping held at 0.49 where the curves ask for more in "),
                               ::testing::EndsWith(" m below the surface")));
}

} // namespace
