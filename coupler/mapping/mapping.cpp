#include "coupler/mapping/mapping.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace tremolo::coupler {

namespace {

/// Cubic Hermite weights at s in [0, 1]: of both end values and, times the interval, of both end slopes.
struct Hermite {
  explicit Hermite(double s)
      : value0((1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s)), slope0(s * (1.0 - s) * (1.0 - s)),
        value1(s * s * (3.0 - 2.0 * s)), slope1(s * s * (s - 1.0)) {}
  double value0;
  double slope0;
  double value1;
  double slope1;
};

/// Weights of the derivative at y[at] of the parabola through the three points y[first .. first+2].
std::array<double, 3> parabola_slope(std::span<const double> y, std::size_t first, std::size_t at) {
  std::array<double, 3> weights{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = y[first + (k + 1) % 3];
    const double b = y[first + (k + 2) % 3];
    const double own = y[first + k];
    weights[k] = ((y[at] - a) + (y[at] - b)) / ((own - a) * (own - b));
  }
  return weights;
}

/// Adds scale times the slope at point j of a layer, whose stencil is centred where there is a point on
/// either side. weights[0] belongs to the layer's point first_weight.
void add_slope(std::span<double> weights, std::size_t first_weight, std::span<const double> y, std::size_t j,
               double scale) {
  const std::size_t first = std::clamp<std::size_t>(j, 1, y.size() - 2) - 1;
  const auto slope = parabola_slope(y, first, j);
  for (std::size_t k = 0; k < 3; ++k)
    weights[first - first_weight + k] += scale * slope[k];
}

/// The points of one layer: between two levels that are listed twice, or an end.
struct LayerPoints {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// The layer at an elevation; on an interface, up to rounding, the one above.
LayerPoints layer_at(const std::vector<double>& y, double elevation) {
  const double hair = 1e-9 * (y.back() - y.front());
  const auto above = std::upper_bound(y.begin(), y.end(), elevation + hair) - y.begin();
  const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - 1, 0));
  std::size_t first = at;
  while (first > 0 && y[first - 1] < y[first])
    --first;
  std::size_t end = at + 1;
  while (end < y.size() && y[end] > y[end - 1])
    ++end;
  return {first, end - first};
}

void check_elevation(const FieldDescription& field, eq6::Vector position) {
  const double tolerance = 1e-3 * (field.y.back() - field.y.front()) + 1e-6;
  if (!(position.y >= field.y.front() - tolerance && position.y <= field.y.back() + tolerance))
    throw std::invalid_argument(
        fmt::format("field '{}' is served from y = {} to {} m, but a face lies at x = {}, y = {} m",
                    field.name, field.y.front(), field.y.back(), position.x, position.y));
}

} // namespace

FaceMap map_face(const FieldDescription& field, eq6::Vector position) {
  check_elevation(field, position);
  const LayerPoints layer = layer_at(field.y, position.y);
  const auto y = std::span(field.y).subspan(layer.first, layer.count);
  FaceMap map;
  map.first_point = layer.first;
  map.delay = field.slowness_x * (position.x - field.x_reference);
  if (y.size() == 1) {
    map.points = 1;
    map.weights[0] = 1.0;
    return map;
  }
  const auto above = std::upper_bound(y.begin(), y.end(), position.y) - y.begin();
  const auto j = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(y) - 2));
  const double interval = y[j + 1] - y[j];
  const double s = (position.y - y[j]) / interval;
  if (y.size() == 2) {
    map.points = 2;
    map.weights = {1.0 - s, s};
    return map;
  }
  const std::size_t lowest = j > 0 ? j - 1 : 0;
  map.first_point += lowest;
  map.points = std::min(j + 3, y.size()) - lowest;
  const Hermite hermite(s);
  map.weights[j - lowest] += hermite.value0;
  map.weights[j + 1 - lowest] += hermite.value1;
  add_slope(map.weights, lowest, y, j, hermite.slope0 * interval);
  add_slope(map.weights, lowest, y, j + 1, hermite.slope1 * interval);
  return map;
}

FreeFieldHistory::FreeFieldHistory(FieldDescription field, double least_delay, double largest_delay,
                                   std::uint64_t look_ahead)
    : field_(std::move(field)), least_delay_(least_delay), largest_delay_(largest_delay),
      capacity_(static_cast<std::uint64_t>(std::ceil((largest_delay - least_delay) / field_.time_step)) + 3 +
                look_ahead),
      ring_(capacity_ * field_.values_per_step()) {}

void FreeFieldHistory::append(std::span<const std::byte> values) {
  const std::size_t count = field_.values_per_step();
  const std::size_t step_bytes = count * sizeof(double);
  const std::uint64_t steps = values.size() / step_bytes;
  if (values.size() != steps * step_bytes || next_step_ + steps > credit())
    throw std::length_error(
        fmt::format("field '{}': {} values from step {} on do not fit, there is room for {} steps",
                    field_.name, values.size() / sizeof(double), next_step_, credit() - next_step_));
  for (std::uint64_t i = 0; i < steps; ++i, ++next_step_)
    if (next_step_ >= first_step_)
      std::memcpy(ring_.data() + next_step_ % capacity_ * count, values.data() + i * step_bytes, step_bytes);
}

void FreeFieldHistory::release_before(double time) {
  first_step_ = std::max(first_step_, interval(time - largest_delay_));
}

std::uint64_t FreeFieldHistory::credit() const {
  // Steps that nobody needs come too, but never more of them at a time than would have to be held.
  return std::min(std::min(first_step_, next_step_) + capacity_, field_.step_count);
}

std::optional<std::uint64_t> FreeFieldHistory::missing(double time) const {
  if (next_step_ >= needed_until(time))
    return std::nullopt;
  return next_step_;
}

void FreeFieldHistory::in_time(double local_time, std::span<const std::size_t> which,
                               std::span<double> points) const {
  const std::uint64_t i = interval(local_time);
  if (i < first_step_ || i + 1 >= next_step_)
    throw std::out_of_range(fmt::format("field '{}': steps {} and {} are not held, only {} to {}",
                                        field_.name, i, i + 1, first_step_, next_step_));
  const double dt = field_.time_step;
  const Hermite hermite((local_time - field_.start_time) / dt - static_cast<double>(i));
  const double slope0 = dt * hermite.slope0;
  const double slope1 = dt * hermite.slope1;
  const double* first_step = step(i);
  const double* second_step = step(i + 1);
  double* point = points.data();
  for (const std::size_t number : which) {
    const double* before = first_step + number * values_per_point;
    const double* after = second_step + number * values_per_point;
    for (std::size_t c = 0; c < components; ++c)
      *point++ = hermite.value0 * before[c] + hermite.value1 * after[c] + slope0 * before[c + components] +
                 slope1 * after[c + components];
  }
}

eq6::FreeField FreeFieldHistory::evaluate(const FaceMap& face, double time) const {
  std::array<std::size_t, std::tuple_size_v<decltype(face.weights)>> which{};
  std::iota(which.begin(), which.end(), face.first_point);
  std::array<double, components * which.size()> points{};
  in_time(time - face.delay, std::span(which).first(face.points), points);
  return in_depth(face, points.data());
}

std::uint64_t FreeFieldHistory::interval(double local_time) const {
  // Rounding may put a time that is meant to be the first or the last step a hair outside.
  constexpr double hair = 1e-6;
  const double s = (local_time - field_.start_time) / field_.time_step;
  if (!(s >= -hair && s <= static_cast<double>(field_.step_count - 1) + hair))
    throw std::out_of_range(
        fmt::format("field '{}' is served from {} to {} s, but its value at {} s is needed", field_.name,
                    field_.start_time, field_.end_time(), local_time));
  return std::min(static_cast<std::uint64_t>(std::max(s, 0.0)), field_.step_count - 2);
}

const double* FreeFieldHistory::step(std::uint64_t number) const {
  return ring_.data() + number % capacity_ * field_.values_per_step();
}

} // namespace tremolo::coupler
