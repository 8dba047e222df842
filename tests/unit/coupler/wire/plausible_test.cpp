// Values that no free field can have are named with step, quantity, point and range.

#include "coupler/wire/plausible.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace tremolo::coupler {
namespace {

const FieldDescription field{.name = "total", .y = {-10.0, -2.5, 0.0}, .time_step = 0.01, .step_count = 100};

/// What is said of four steps of zeros from step 40 on, in which one value is another.
std::string told(std::size_t step, std::size_t point, std::size_t quantity, double value) {
  std::vector<double> values(4 * field.values_per_step(), 0.0);
  values[(step * field.y.size() + point) * values_per_point + quantity] = value;
  return implausible(field, 40, std::as_bytes(std::span(values))).value_or("");
}

TEST(Plausible, NamesStepQuantityPointAndRange) {
  EXPECT_EQ(told(2, 1, 0, 1e200),
            "step 42: velocity vx at y = -2.5 m (point 1 of 3) is 1e+200 m/s, allowed are -100 to 100 m/s");
  EXPECT_EQ(told(0, 0, 4, -1e308),
            "step 40: stress sxy at y = -10 m (point 0 of 3) is -1e+308 Pa, allowed are -1e+10 to 1e+10 Pa");
  EXPECT_EQ(
      told(3, 2, 6, 2e5),
      "step 43: acceleration ay at y = 0 m (point 2 of 3) is 200000 m/s2, allowed are -100000 to 100000 "
      "m/s2");
  EXPECT_EQ(
      told(3, 2, 9, 2e13),
      "step 43: rate of stress sxy at y = 0 m (point 2 of 3) is 2e+13 Pa/s, allowed are -1e+13 to 1e+13 "
      "Pa/s");
}

TEST(Plausible, FindsWhatIsNotFiniteInEveryPlace) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(), 1e308})
    for (std::size_t quantity = 0; quantity < values_per_point; ++quantity)
      for (const std::size_t step : {0U, 3U})
        for (std::size_t point = 0; point < field.y.size(); ++point)
          EXPECT_NE(told(step, point, quantity, bad), "");
}

TEST(Plausible, TakesStrongMotionOverHardRock) {
  // 10 m/s in rock of 2700 kg/m3 and 6 km/s: rho c_p v = 162 MPa; at 30 Hz, 1900 m/s2.
  const std::vector<double> one{10.0, -10.0, 1.62e8, -1.62e8, 1e8, 1.9e3, -1.9e3, 3e10, -3e10, 2e10};
  std::vector<double> values;
  for (std::size_t point = 0; point < field.y.size(); ++point)
    values.insert(values.end(), one.begin(), one.end());
  EXPECT_EQ(implausible(field, 0, std::as_bytes(std::span(values))), std::nullopt);
}

} // namespace
} // namespace tremolo::coupler
