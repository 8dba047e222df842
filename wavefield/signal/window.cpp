#include "wavefield/signal/window.hpp"

#include "base/require.hpp"
#include "wavefield/signal/fourier.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::wavefield {
namespace {

constexpr std::size_t largest_window = std::size_t{1} << 27;

/// exp(-epsilon T) = 1e-7; the rounding of late samples is amplified by its inverse.
constexpr double exponent_over_window = 16.0;

Window window_from(const TimeGrid& grid, const Interval& interval, double before, double padding,
                   double highest_frequency) {
  // Four samples a period of the highest frequency: Nyquist's limit twice over.
  const double stride = std::max(1.0, std::ceil(grid.dt * 4.0 * highest_frequency));
  Window window;
  window.dt = grid.dt / stride;
  const double length = std::ceil(padding * (interval.end - interval.begin) / window.dt);
  require(stride < 1e6 && length < static_cast<double>(largest_window),
          "number of samples of the Fourier window", length,
          "below 2^27: shorten the record, or lower the highest frequency of the signal");
  window.stride = static_cast<std::size_t>(stride);
  window.length = fast_length(static_cast<std::size_t>(length) + 2);
  window.offset = static_cast<std::size_t>(std::ceil((before + grid.start - interval.begin) / window.dt));
  window.start = grid.start - static_cast<double>(window.offset) * window.dt;
  return window;
}

} // namespace

double Window::omega(std::size_t bin) const {
  return 2.0 * std::numbers::pi * static_cast<double>(bin) / duration();
}

Window make_window(const TimeGrid& grid, const Interval& interval, double padding, double highest_frequency) {
  const double before = 0.5 * (padding - 1.0) * (interval.end - interval.begin);
  return window_from(grid, interval, before, padding, highest_frequency);
}

Window make_exponential_window(const TimeGrid& grid, const Interval& interval, double padding,
                               double highest_frequency) {
  Window window = window_from(grid, interval, 0.0, padding, highest_frequency);
  window.epsilon = exponent_over_window / window.duration();
  return window;
}

} // namespace tremolo::wavefield
