#include "app/study/design.hpp"

#include "base/random/variates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace tremolo::app {

namespace {

/// Fisher & Yates.
std::vector<std::size_t> permutation(std::size_t count, std::mt19937_64& generator) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(uniform(generator) * static_cast<double>(i))]);
  return order;
}

/// The value at a point of [0, 1) of an axis.
scene::AxisValue sampled(const scene::Axis& axis, double at) {
  if (!axis.range)
    return axis.values[static_cast<std::size_t>(at * static_cast<double>(axis.values.size()))];
  const auto& [low, high, scale] = *axis.range;
  const double value =
      scale == scene::RangeScale::log ? low * std::pow(high / low, at) : low + (high - low) * at;
  const std::string text = fmt::format("{}", value);
  return {text, text, axis.place};
}

std::vector<Combination> list(const std::vector<scene::Axis>& axes) {
  std::size_t length = 1;
  for (const scene::Axis& axis : axes)
    length = std::max(length, axis.values.size());
  std::vector<Combination> all(length);
  for (std::size_t i = 0; i < length; ++i)
    for (const scene::Axis& axis : axes)
      all[i].push_back(axis.values[axis.values.size() == 1 ? 0 : i]);
  return all;
}

} // namespace

std::vector<Combination> product(const std::vector<scene::Axis>& axes) {
  std::vector<Combination> all(1);
  for (const scene::Axis& axis : axes) {
    std::vector<Combination> longer;
    longer.reserve(all.size() * axis.values.size());
    for (const Combination& values : all)
      for (const scene::AxisValue& value : axis.values) {
        longer.push_back(values);
        longer.back().push_back(value);
      }
    all = std::move(longer);
  }
  return all;
}

std::vector<std::vector<double>> latin_hypercube(std::size_t samples, std::size_t dimensions,
                                                 std::uint32_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<std::vector<double>> points(samples, std::vector<double>(dimensions));
  for (std::size_t d = 0; d < dimensions; ++d) {
    const auto order = permutation(samples, generator);
    for (std::size_t i = 0; i < samples; ++i)
      points[i][d] = (static_cast<double>(order[i]) + uniform(generator)) / static_cast<double>(samples);
  }
  return points;
}

std::vector<Combination> combinations(const scene::Study& study, const std::vector<scene::Axis>& axes) {
  if (study.design == scene::SweepDesign::product)
    return product(axes);
  if (study.design == scene::SweepDesign::list)
    return list(axes);
  std::vector<Combination> all;
  for (const auto& point :
       latin_hypercube(static_cast<std::size_t>(study.samples), axes.size(), study.seed)) {
    Combination values;
    for (std::size_t a = 0; a < axes.size(); ++a)
      values.push_back(sampled(axes[a], point[a]));
    all.push_back(std::move(values));
  }
  return all;
}

} // namespace tremolo::app
