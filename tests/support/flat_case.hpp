#pragma once

// The small case of the tests: level, uniform, elastic ground, 20 m x 10 m, h = 1 m.

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace tremolo::testing {

inline constexpr std::string_view flat_case = R"(title = "flat"
[motion]
pulse = { shape = "ricker", frequency = 3.0, time = 1.0, velocity = 0.1 }
wave = "SV"
angle_deg = 0.0
reference = [0.0, -10.0]
[surface]
level = 0.0
[halfspace]
density = 1700.0
young = 40e6
poisson = 0.28
[soil.sand]
model = "linear_elastic"
density = 1700.0
young = 40e6
poisson = 0.28
[[region]]
soil = "sand"
polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]
[mesh]
size = 1.0
box = [0.0, -10.0, 20.0, 0.0]
[boundary]
left = { model = "wave" }
right = { model = "wave" }
base = { model = "wave", form = "total" }
[[stage]]
kind = "shaking"
duration_s = 2.0
)";

/// The flat case with the first occurrence of `old` replaced.
inline std::string with(std::string_view old, std::string_view replacement,
                        std::string text = std::string(flat_case)) {
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), replacement);
}

/// The flat case with more at its end.
inline std::string plus(std::string_view more) {
  return std::string(flat_case) + std::string(more);
}

} // namespace tremolo::testing
