#include "materials/law/finite_input.hpp"

#include "base/lanes.hpp"

#include <fmt/format.h>

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

/// @param size  values of a point
void check(std::string_view law, std::string_view what, const double* values, std::size_t count,
           std::size_t size) {
  if (values == nullptr || finite(values, count * size))
    return;
  std::size_t i = 0;
  while (std::isfinite(values[i]))
    ++i;
  throw std::domain_error(
      fmt::format("{}: {} of point {} is {:g}, not a finite number", law, what, i / size, values[i]));
}

} // namespace

void check_finite(std::string_view law, const Points& points, std::size_t state_size) {
  check(law, "stress xx", points.sxx, points.count, 1);
  check(law, "stress yy", points.syy, points.count, 1);
  check(law, "stress zz", points.szz, points.count, 1);
  check(law, "stress xy", points.sxy, points.count, 1);
  check(law, "the state", points.state, points.count, state_size);
}

} // namespace tremolo::materials
