// Mapping in depth and time against fields that are known in closed form.

#include "coupler/mapping/mapping.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace tremolo::coupler {
namespace {

using Function = std::function<double(double y, double t)>;

FieldDescription field_on(std::vector<double> y, double dt, std::uint64_t steps) {
  return {.name = "total", .y = std::move(y), .start_time = -1.0, .time_step = dt, .step_count = steps};
}

std::vector<double> elevations(std::size_t intervals) {
  std::vector<double> y;
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(intervals);
    y.push_back(-40.0 + 40.0 * (s + 0.1 * std::sin(3.0 * s))); // not uniform
  }
  return y;
}

/// A history that holds all steps of a function and its time derivative, component c scaled by c + 1.
FreeFieldHistory filled(const FieldDescription& field, const Function& f, const Function& f_t) {
  FreeFieldHistory history(field, 0.0, 0.0, field.step_count);
  for (std::uint64_t n = 0; n < field.step_count; ++n) {
    std::vector<double> values;
    for (const double y : field.y) {
      for (int c = 1; c <= 5; ++c)
        values.push_back(c * f(y, field.time(n)));
      for (int c = 1; c <= 5; ++c)
        values.push_back(c * f_t(y, field.time(n)));
    }
    history.append(std::as_bytes(std::span(values)));
  }
  return history;
}

double largest_error(const FieldDescription& field, const Function& f, const Function& f_t, double t0,
                     double t1) {
  const auto history = filled(field, f, f_t);
  double error = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const double y = field.y.front() + (field.y.back() - field.y.front()) * i / 100.0;
    const auto map = map_face(field, {0.0, y});
    for (int j = 0; j <= 97; ++j) {
      const double t = t0 + (t1 - t0) * j / 97.0;
      const auto found = history.evaluate(map, t);
      const double exact = f(y, t);
      for (const double e :
           {found.velocity.x - exact, found.velocity.y - 2 * exact, found.stress.xx - 3 * exact,
            found.stress.yy - 4 * exact, found.stress.xy - 5 * exact})
        error = std::max(error, std::abs(e));
    }
  }
  return error;
}

TEST(Mapping, ExactForParabolasInDepthAndCubicsInTime) {
  const Function f = [](double y, double t) {
    return (1.0 + 0.3 * y - 0.02 * y * y) * (t * t * t - 2.0 * t);
  };
  const Function f_t = [](double y, double t) {
    return (1.0 + 0.3 * y - 0.02 * y * y) * (3.0 * t * t - 2.0);
  };
  for (const std::size_t intervals : {2U, 3U, 9U})
    EXPECT_LT(largest_error(field_on(elevations(intervals), 0.1, 21), f, f_t, -1.0, 1.0), 1e-11);
}

TEST(Mapping, ExactForLinesWithTwoPointsAndForConstantsWithOne) {
  const Function line = [](double y, double) { return 1.0 + 0.3 * y; };
  const Function constant = [](double, double) { return 4.0; };
  const Function zero = [](double, double) { return 0.0; };
  EXPECT_LT(largest_error(field_on({-40.0, 0.0}, 0.1, 21), line, zero, -1.0, 1.0), 1e-12);
  EXPECT_LT(largest_error(field_on({-40.0}, 0.1, 21), constant, zero, -1.0, 1.0), 1e-14);
}

TEST(Mapping, FourthOrderInTime) {
  const Function f = [](double, double t) { return std::sin(7.0 * t); };
  const Function f_t = [](double, double t) { return 7.0 * std::cos(7.0 * t); };
  const double coarse = largest_error(field_on({-1.0, 0.0}, 0.05, 41), f, f_t, -1.0, 1.0);
  const double fine = largest_error(field_on({-1.0, 0.0}, 0.025, 81), f, f_t, -1.0, 1.0);
  EXPECT_GT(std::log2(coarse / fine), 3.8);
  EXPECT_LT(coarse,
            5.0 * std::pow(7.0 * 0.05, 4) / 384.0 * 1.01); // 5: scale of sxy; the bound of cubic Hermite
}

TEST(Mapping, ThirdOrderInDepth) {
  const Function f = [](double y, double) { return std::cos(0.15 * y); };
  const Function zero = [](double, double) { return 0.0; };
  const double coarse = largest_error(field_on(elevations(40), 0.5, 5), f, zero, -1.0, 1.0);
  const double fine = largest_error(field_on(elevations(80), 0.5, 5), f, zero, -1.0, 1.0);
  EXPECT_GT(std::log2(coarse / fine), 2.8);
}

/// Cubics that jump at two interfaces, as s_xx does, below, between and above them.
double layered(double y) {
  if (y < -25.0)
    return 1.0 + 0.05 * y * y + 1e-3 * y * y * y;
  if (y < -10.0)
    return -4.0 + 0.3 * y - 2e-3 * y * y * y;
  return 20.0 + 3.0 * y + 4e-3 * y * y * y;
}

/// Levels of which the interfaces stand twice, in uneven layers of `intervals` intervals each.
std::vector<double> layered_levels(int intervals) {
  std::vector<double> y;
  for (const auto& [bottom, top] : {std::pair{-40.0, -25.0}, {-25.0, -10.0}, {-10.0, 0.0}})
    for (int i = 0; i <= intervals; ++i) {
      const double s = static_cast<double>(i) / intervals;
      y.push_back(i == intervals ? top : bottom + (top - bottom) * (s + 0.1 * s * (1.0 - s)));
    }
  return y;
}

/// The largest error of the mapping of values that are given at the levels, against layered(); an interface
/// itself has its value from above.
double layered_error(const std::vector<double>& y, const std::vector<double>& values) {
  const auto field = field_on(y, 1.0, 2);
  double error = 0.0;
  for (int i = 0; i <= 4000; ++i) {
    const double at = -40.0 + 0.01 * i;
    const auto map = map_face(field, {0.0, at});
    double found = 0.0;
    for (std::size_t k = 0; k < map.points; ++k)
      found += map.weights[k] * values[map.first_point + k];
    error = std::max(error, std::abs(found - layered(at)));
  }
  return error;
}

/// Values at levels, of which the first of two equal ones takes the limit from below.
std::vector<double> two_sided_values(const std::vector<double>& y) {
  std::vector<double> values;
  for (std::size_t i = 0; i < y.size(); ++i)
    values.push_back(layered(i + 1 < y.size() && y[i + 1] == y[i] ? std::nextafter(y[i], -100.0) : y[i]));
  return values;
}

TEST(Mapping, LayersKeepTheOrderWhereInterfacesStandTwice) {
  const auto error = [](int intervals) {
    return layered_error(layered_levels(intervals), two_sided_values(layered_levels(intervals)));
  };
  EXPECT_GT(std::log2(error(10) / error(20)), 2.8);
  EXPECT_GT(std::log2(error(20) / error(40)), 2.8);
}

TEST(Mapping, JumpIsSmearedWhereInterfacesStandOnce) {
  for (const int intervals : {10, 40}) {
    auto y = layered_levels(intervals);
    y.erase(std::unique(y.begin(), y.end()), y.end());
    std::vector<double> values;
    for (const double level : y)
      values.push_back(layered(level));
    // Half the jump of 9 at -10 m at least, however fine the levels.
    EXPECT_GT(layered_error(y, values), 4.5) << intervals;
  }
}

TEST(Mapping, ReachesAcrossNoInterface) {
  const auto field = field_on({-3.0, -2.0, -2.0, -1.0, -1.0, 0.0, 1.0}, 1.0, 2);
  const auto expect_points = [&](double y, std::size_t first, std::size_t count) {
    const auto map = map_face(field, {0.0, y});
    EXPECT_EQ(map.first_point, first) << y;
    EXPECT_EQ(map.points, count) << y;
  };
  expect_points(-2.5, 0, 2);
  expect_points(-2.0 - 1e-6, 0, 2);
  expect_points(-2.0 - 1e-12, 2, 2); // on the interface but for rounding
  expect_points(-2.0, 2, 2);
  expect_points(-1.0, 4, 3);
  expect_points(1.0, 4, 3);
}

TEST(Mapping, FaceAheadOfTheProfileIsLaterByTheSlowness) {
  auto field = field_on({-1.0, 0.0}, 0.01, 301);
  field.x_reference = 10.0;
  field.slowness_x = 0.002;
  const Function f = [](double, double t) { return std::sin(3.0 * t); };
  const Function f_t = [](double, double t) { return 3.0 * std::cos(3.0 * t); };
  const auto history = filled(field, f, f_t);
  const auto map = map_face(field, {110.0, -0.5});
  EXPECT_DOUBLE_EQ(map.delay, 0.2);
  EXPECT_NEAR(history.evaluate(map, 0.7).velocity.x, std::sin(3.0 * 0.5), 1e-8);
}

TEST(Mapping, FaceOutsideTheProfileIsRefused) {
  const auto field = field_on({-40.0, -20.0, 0.0}, 0.1, 3);
  EXPECT_NO_THROW(map_face(field, {0.0, 0.0}));
  EXPECT_THROW(map_face(field, {0.0, 0.5}), std::invalid_argument);
  EXPECT_THROW(map_face(field, {0.0, -40.5}), std::invalid_argument);
  EXPECT_THROW(map_face(field, {0.0, NAN}), std::invalid_argument);
}

TEST(FreeFieldHistory, HoldsABoundedWindowAndNothingStale) {
  const auto field = field_on({0.0}, 0.1, 1000);
  FreeFieldHistory history(field, -0.5, 0.5, 8); // 10 steps of delay, 3 of interpolation, 8 ahead
  const std::vector<double> one_step(values_per_point, 1.0);
  history.release_before(0.5);      // the earliest local time is 0.0 s, step 10
  EXPECT_EQ(history.credit(), 21U); // steps before it come too, but no more of them at a time
  while (history.next_step() < history.credit())
    history.append(std::as_bytes(std::span(one_step)));
  EXPECT_EQ(history.credit(), 10U + 21U);
  EXPECT_THROW(history.append(std::as_bytes(std::span(one_step))), std::length_error);
  EXPECT_FALSE(history.missing(0.5 + 0.8));
  EXPECT_EQ(history.missing(3.0), 31U);
  const FaceMap late{.first_point = 0, .points = 1, .weights = {1.0}, .delay = 0.5};
  EXPECT_DOUBLE_EQ(history.evaluate(late, 0.5).velocity.x, 1.0);
  history.release_before(0.75);
  EXPECT_THROW(static_cast<void>(history.evaluate(late, 0.55)), std::out_of_range);
  EXPECT_EQ(history.credit(), 12U + 21U);
}

TEST(FreeFieldHistory, TimesBeyondTheServedOnesAreRefused) {
  const auto field = field_on({0.0}, 0.1, 11); // from -1 to 0 s
  const auto history = filled(
      field, [](double, double t) { return t; }, [](double, double) { return 1.0; });
  const auto map = map_face(field, {0.0, 0.0});
  EXPECT_DOUBLE_EQ(history.evaluate(map, -1.0).velocity.x, -1.0);
  EXPECT_NEAR(history.evaluate(map, 0.0).velocity.x, 0.0, 1e-15);
  EXPECT_THROW(static_cast<void>(history.evaluate(map, -1.001)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(history.evaluate(map, 0.001)), std::out_of_range);
}

} // namespace
} // namespace tremolo::coupler
