// What the rule of outcrops under two waves says of their motion, against the reflection at the free surface.

#include "scene/case.hpp"
#include "wavefield/layers/transfer.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace {

using namespace tremolo;

constexpr const char* text = R"(title = "two waves at an outcrop"
[motion]
kind = "outcrop"
pulse = { shape = "ricker", frequency = 3.0, time = 1.0, velocity = 0.1 }
wave = "SV"
angle_deg = 10.0
reference = [0.0, -10.0]
[motion.vertical]
pulse = { shape = "ricker", frequency = 3.0, time = 1.0, velocity = 0.1 }
angle_deg = 25.0
[surface]
level = 0.0
[halfspace]
density = 1700.0
vs = 200.0
vp = 420.0
[mesh]
size = 1.0
box = [0.0, -10.0, 20.0, 0.0]
[soil.rock]
model = "linear_elastic"
density = 1700.0
vs = 200.0
vp = 420.0
[[region]]
soil = "rock"
polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]
[boundary]
left = { model = "wave" }
right = { model = "wave" }
base = { model = "wave" }
[[stage]]
kind = "shaking"
duration_s = 2.0
)";

TEST(OutcropOfTwoWaves, MovesAsTheRuleSays) {
  const scene::Case scene = scene::parse(text, "case.toml", ".");
  const auto ground = wavefield::ground_from_case(scene, {});
  const auto moved = [&](const scene::MotionInput& wave) {
    const auto incidence = wavefield::incidence_of(wave);
    return wavefield::outcrop(ground.half_space, incidence.wave, incidence.angle_rad);
  };
  const auto sv = moved(scene.motion), p = moved(*scene.vertical);
  const std::string expected =
      fmt::format("its record and {:.2g} times the horizontal one, the horizontal motion its "
                  "record and {:.2g} times the vertical one",
                  std::abs(sv.uy / sv.ux), std::abs(p.ux / p.uy));
  bool said = false;
  for (const scene::Finding& remark : scene.remarks)
    said = said || remark.message().find(expected) != std::string::npos;
  EXPECT_TRUE(said) << expected;
}

} // namespace
