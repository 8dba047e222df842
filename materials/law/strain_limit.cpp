#include "materials/law/strain_limit.hpp"

#include "base/lanes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace tremolo::materials {
namespace {

constexpr double largest_rotation = 1.0; // rad

/// Whether |values[i]| <= limit for all of them; a value that is not a number is outside.
bool within(const double* values, std::size_t count, double limit) {
  LaneMask outside{};
  by_fours(0, count,
           [&](std::size_t i, auto group) { outside |= ~(magnitude(group.load(values + i)) <= limit); });
  return !any(outside);
}

void check(std::string_view law, std::string_view component, const double* values, std::size_t count,
           double limit) {
  if (values == nullptr || within(values, count, limit))
    return;
  std::size_t i = 0;
  while (std::abs(values[i]) <= limit)
    ++i;
  throw std::domain_error(fmt::format("{}: {} = {:g} of point {} in one step is outside [{:g}, {:g}]; take "
                                      "smaller steps",
                                      law, component, values[i], i, -limit, limit));
}

} // namespace

void check_increments(std::string_view law, const Points& points, double limit) {
  check(law, "strain increment xx", points.dexx, points.count, limit);
  check(law, "strain increment yy", points.deyy, points.count, limit);
  check(law, "strain increment zz", points.dezz, points.count, limit);
  check(law, "shear strain increment xy", points.dgxy, points.count, limit);
  check(law, "rotation increment", points.dwxy, points.count, largest_rotation);
}

} // namespace tremolo::materials
