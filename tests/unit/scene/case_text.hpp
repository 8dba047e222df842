#pragma once

// A small valid case, and what becomes of it when a piece of its text is replaced.

#include "scene/case.hpp"
#include "scene/text/errors.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene::testing {

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

inline Case parse_case(const std::string& text) {
  return parse(text, "case.toml", ".");
}

/// Messages of all errors; empty for a good case.
inline std::vector<std::string> errors_of(const std::string& text) {
  std::vector<std::string> messages;
  try {
    parse_case(text);
  } catch (const CaseErrors& errors) {
    for (const Finding& error : errors.errors())
      messages.push_back(error.message());
  }
  return messages;
}

/// Messages of the warnings and notes on a good case.
inline std::vector<std::string> remarks_of(const std::string& text) {
  std::vector<std::string> messages;
  for (const Finding& remark : parse_case(text).remarks)
    messages.push_back(remark.message());
  return messages;
}

} // namespace tremolo::scene::testing
