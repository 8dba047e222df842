#include "materials/law/finite_input.hpp"

#include "base/lanes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tremolo::materials {
namespace {

bool finite(const double* values, std::size_t count) {
  LaneMask wrong{};
  by_fours(0, count, [&](std::size_t i, auto group) {
    wrong |= ~(magnitude(group.load(values + i)) <= std::numeric_limits<double>::max());
  });
  return !any(wrong);
}

[[noreturn]] void refuse(std::string_view law, std::string_view what, std::size_t point, double value) {
  throw std::domain_error(
      fmt::format("{}: {} of point {} is {:g}, not a finite number", law, what, point, value));
}

void check_stress(std::string_view law, std::string_view what, const double* values, std::size_t count) {
  if (values == nullptr || finite(values, count))
    return;
  std::size_t i = 0;
  while (std::isfinite(values[i]))
    ++i;
  refuse(law, what, i, values[i]);
}

} // namespace

void check_finite(std::string_view law, const Points& points, std::size_t state_size, std::size_t checked) {
  check_stress(law, "stress xx", points.sxx, points.count);
  check_stress(law, "stress yy", points.syy, points.count);
  check_stress(law, "stress zz", points.szz, points.count);
  check_stress(law, "stress xy", points.sxy, points.count);
  for (std::size_t i = 0; i < points.count; ++i)
    if (const double* const state = points.state + i * state_size; !finite(state, checked))
      refuse(law, "the state", i,
             *std::find_if_not(state, state + checked, [](double v) { return std::isfinite(v); }));
}

} // namespace tremolo::materials
