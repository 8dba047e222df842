// The field is linear in the incident motion, and forgets it: what a pulse at t = 0 does is below `forgotten`
// of its peak before t = -a and after t = m. So on [t0, t1] the field is that of the motion times
//
//   w(t) = (erfc((t0 - m - r - t)/d) - erfc((t1 + a + r - t)/d))/2,      r = 5 d,
//
// which is 1 to 1e-12 on [t0 - m, t1 + a] and 0 to 1e-12 a length r outside. The spectrum exp(-(pi f d)^2) of
// the slope of w is 1e-10 at f = 1.5/d, by which the motion's highest frequency grows.
//
// Beyond the critical angle, with constant and with Kjartansson damping the field does not forget: its
// spectrum is not smooth at zero frequency, so that it has algebraic tails in proportion to the displacement
// that the motion leaves. There the motion is split in two. Its slow part (low_pass.hpp) is computed whole,
// in steps so long that it needs little memory, and interpolated by cubic Hermite polynomials. A piece has
// the rest of the motion times w, whose spectrum begins like f^4, so that its tails fall like t^-5 or faster.

#include "wavefield/layers/long_field.hpp"

#include "wavefield/signal/low_pass.hpp"
#include "wavefield/signal/window.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tremolo::wavefield {
namespace {

constexpr std::size_t most_steps_at_once = std::size_t{1} << 17;
constexpr std::size_t piece_steps = std::size_t{1} << 16;
constexpr std::size_t longest_reach = std::size_t{1} << 17; ///< steps, before and after

constexpr double forgotten = 1e-8;

constexpr double flank_periods = 8.0;   ///< d of w times the highest frequency of the motion
constexpr double flank_frequency = 1.5; ///< times d

/// Highest frequency of the motion over the corner of its slow part.
constexpr double slow_ratio = 200.0;
/// Samples of the slow part in a period of its highest frequency. A period of its corner has 88 of them:
/// there cubic interpolation errs by (2 pi/88)^4/384 = 7e-8.
constexpr double slow_samples = 40.0;

constexpr Quantities served{.displacement = false, .strain = false};

struct Rated {
  std::vector<double> History::*value;
  std::vector<double> History::*rate;
};
constexpr std::array series{Rated{&History::vx, &History::vx_rate}, Rated{&History::vy, &History::vy_rate},
                            Rated{&History::sxx, &History::sxx_rate},
                            Rated{&History::syy, &History::syy_rate},
                            Rated{&History::sxy, &History::sxy_rate}};

/// exp(-(pi f t)^2), 1 m/s at t = 0, whose spectrum exp(-(w/(2 pi f))^2) ends at the same frequency as the
/// motion's: it holds all frequencies from zero on.
Signal gaussian(double highest_frequency) {
  const double frequency = highest_frequency / 5.0;
  const double half_width = 6.0 / (std::numbers::pi * frequency);
  return {[frequency](double t) { return std::exp(-std::pow(std::numbers::pi * frequency * t, 2)); },
          -half_width, half_width, highest_frequency};
}

/// A signal without another one that has lower frequencies.
Signal without(const Signal& signal, const Signal& slow) {
  return {[all = signal, slow = slow.velocity](double t) {
            return (t >= all.begin && t <= all.end ? all.velocity(t) : 0.0) - slow(t);
          },
          slow.begin, slow.end, signal.highest_frequency};
}

/// The motion on an interval, cut off smoothly outside.
Signal cut(const Signal& signal, const Interval& kept) {
  const double d = flank_periods / signal.highest_frequency;
  const double r = 5.0 * d;
  const auto velocity = [whole = signal.velocity, kept, d, r](double t) {
    return 0.5 * (std::erfc((kept.begin - r - t) / d) - std::erfc((kept.end + r - t) / d)) * whole(t);
  };
  Signal part{velocity, std::max(signal.begin, kept.begin - 2.0 * r),
              std::min(signal.end, kept.end + 2.0 * r), signal.highest_frequency + flank_frequency / d};
  if (part.end <= part.begin) // the motion is over, or has not begun
    return {[](double) { return 0.0; }, kept.begin, kept.end, signal.highest_frequency};
  return part;
}

/// Adds values on a coarse grid with their rates to values on a fine one.
void add_interpolated(const History& coarse, const TimeGrid& from, History& fine, const TimeGrid& to) {
  for (const auto& [value, rate] : series) {
    const auto& v = coarse.*value;
    const auto& d = coarse.*rate;
    for (std::size_t i = 0; i < to.count; ++i) {
      const double place = (to.start + static_cast<double>(i) * to.dt - from.start) / from.dt;
      const auto k = std::min(static_cast<std::size_t>(place), v.size() - 2);
      const double x = place - static_cast<double>(k);
      const double step = v[k + 1] - v[k];
      const double a = from.dt * d[k] - step;
      const double b = step - from.dt * d[k + 1];
      (fine.*value)[i] += v[k] + x * (step + (1.0 - x) * (a * (1.0 - x) + b * x));
      (fine.*rate)[i] +=
          (step + (1.0 - 2.0 * x) * (a * (1.0 - x) + b * x) + x * (1.0 - x) * (b - a)) / from.dt;
    }
  }
}

} // namespace

/// Empty if it is too long.
std::optional<LongField::Reach> LongField::reach_of(const LayeredField& pulse, std::span<const Point> points,
                                                    double dt, Part part) {
  const auto [low, high] = std::ranges::minmax(points, {}, &Point::y);
  for (std::size_t half = longest_reach / 32; half <= longest_reach; half *= 2) {
    const TimeGrid times{-static_cast<double>(half) * dt, dt, 2 * half};
    const auto histories = pulse.sample(std::array{low, high}, times, part, served);
    Reach reach;
    for (const auto& [value, rate] : series) {
      double peak = 0.0;
      for (const History& h : histories)
        for (const double v : h.*value)
          peak = std::max(peak, std::abs(v));
      for (const History& h : histories)
        for (std::size_t i = 0; i < times.count; ++i)
          if (std::abs((h.*value)[i]) > forgotten * peak) {
            const double t = times.start + static_cast<double>(i) * times.dt;
            reach = {std::max(reach.before, -t), std::max(reach.after, t)};
          }
    }
    if (std::max(reach.before, reach.after) < 0.9 * static_cast<double>(half) * dt)
      return reach;
  }
  return std::nullopt;
}

LongField::LongField(const LayeredField& field, std::span<const Point> points, const TimeGrid& times,
                     Part part)
    : field_(field), times_(times), part_(part), pieces_{times} {
  if (times.count <= most_steps_at_once)
    return;
  const Signal& motion = field.signal();
  corner_ = motion.highest_frequency / slow_ratio;
  Signal pulse = gaussian(motion.highest_frequency);
  if (field.has_tails(part))
    pulse = without(pulse, low_passed(pulse, corner_));
  const auto reach = reach_of(field.with_signal(pulse, 1.0), points, times.dt, part);
  if (!reach)
    return;
  reach_ = *reach;
  scale_ = peak_velocity(motion);
  if (field.has_tails(part)) {
    const Signal slow = low_passed(motion, corner_);
    slow_ = field.with_signal(slow, scale_);
    const double dt = 1.0 / (slow_samples * slow.highest_frequency);
    slow_times_ = {times.start, dt,
                   static_cast<std::size_t>(std::ceil(static_cast<double>(times.count) * times.dt / dt)) + 2};
  }
  pieces_.clear();
  for (std::size_t first = 0; first < times.count; first += piece_steps)
    pieces_.push_back({times.start + static_cast<double>(first) * times.dt, times.dt,
                       std::min(piece_steps, times.count - first)});
}

void LongField::sample(std::span<const Point> points,
                       const std::function<void(std::size_t, const std::vector<History>&)>& take) const {
  if (pieces_.size() == 1) {
    take(0, field_.sample(points, times_, part_, served));
    return;
  }
  std::vector<History> slow;
  if (slow_)
    slow = slow_->sample(points, slow_times_, part_, served);
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
    const TimeGrid& times = pieces_[piece];
    const double end = times.start + static_cast<double>(times.count) * times.dt;
    const Interval kept{times.start - reach_.after, end + reach_.before};
    Signal motion = cut(field_.signal(), kept);
    if (slow_)
      motion = without(motion, low_passed(motion, corner_));
    auto histories = field_.with_signal(motion, scale_).sample(points, times, part_, served);
    for (std::size_t i = 0; i < slow.size(); ++i)
      add_interpolated(slow[i], slow_times_, histories[i], times);
    take(piece, histories);
  }
}

} // namespace tremolo::wavefield
