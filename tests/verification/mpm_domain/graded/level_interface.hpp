#pragma once

// A strip without sides whose cells change their size at y = 0, the waves that meet it there, and what a
// lumped chain reflects (reflection_test.cpp has the closed form).

#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

namespace tremolo::mpm_domain {

enum class Body { p, sv };

constexpr double h = 1.0;     // of the coarse cells, m
constexpr double width = 2.0; // of a period, m

/// @param half           of its length on either side of the interface, m
/// @param is_fine_below  or above
inline Spec level_interface(double half, bool is_fine_below) {
  Spec spec = test_support::elastic_box(width, 2.0 * half, h);
  spec.box = {0.0, -half, width, half};
  spec.regions = {{0, {{0.0, -half}, {width, -half}, {width, half}, {0.0, half}}}};
  spec.sides = mpm_domain::Sides::periodic;
  spec.threads = 1;
  spec.refine = {{{0.0, is_fine_below ? -half : 0.0, width, is_fine_below ? 0.0 : half}, 1}};
  return spec;
}

/// |R| of waves with so many coarse cells a wave length in time, c/(f h).
inline double reflected_by_impedances(double cells) {
  const double x = std::numbers::pi / cells;
  const double fine = std::sqrt(1.0 - 0.25 * x * x);
  const double coarse = std::sqrt(1.0 - x * x);
  return (fine - coarse) / (fine + coarse);
}

/// A wave and whether it comes from the fine side.
using Arrival = std::tuple<Body, bool>;

inline auto every_arrival() {
  return testing::Combine(testing::Values(Body::p, Body::sv), testing::Bool());
}

inline std::string name_of_arrival(const testing::TestParamInfo<Arrival>& of) {
  return std::string(std::get<0>(of.param) == Body::p ? "P" : "Sv") +
         (std::get<1>(of.param) ? "FromTheFineSide" : "FromTheCoarseSide");
}

} // namespace tremolo::mpm_domain
