#include "scene/plan/wave/motion.hpp"

#include "motion/band_limited.hpp"
#include "motion/read/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace tremolo::scene {

class Motion::Shape {
public:
  virtual ~Shape() = default;
  virtual double velocity(double t) const = 0;
};

namespace {

constexpr double rise_time = 0.1; // s
constexpr double fall_time = 1.0; // s

/// Steps before the first sample, in which what a band-limited function does before its first sample fades
/// in.
constexpr std::size_t lead = 16;

/// Steps of the table of values and slopes in one of the record: cubics between them err by (pi/8)^4/384 =
/// 6e-5 of an amplitude at the Nyquist frequency, and by the fourth power less below.
constexpr std::size_t refinement = 8;

/// Half a cosine from 1 at s = 0 to 0 at s = 1.
double falling(double s) {
  return 0.5 * (1.0 + std::cos(std::numbers::pi * std::clamp(s, 0.0, 1.0)));
}

std::size_t samples_of_fall(double dt) {
  return std::max<std::size_t>(static_cast<std::size_t>(std::ceil(fall_time / dt)), 2);
}

void require_record(std::span<const double> samples, double dt) {
  const auto finite = [](double v) { return std::isfinite(v); };
  if (samples.size() < 2 || !(dt > 0.0) || !std::isfinite(dt) || !std::ranges::all_of(samples, finite))
    throw std::invalid_argument(fmt::format(
        "a record needs at least 2 finite samples and dt > 0, has {} and dt = {} s", samples.size(), dt));
}

} // namespace

class Motion::Ricker final : public Motion::Shape {
public:
  explicit Ricker(const RickerPulse& pulse) : pulse_(pulse) {}

  double velocity(double t) const override {
    const double root = std::numbers::pi * pulse_.frequency * (t - pulse_.time);
    const double a = root * root;
    return pulse_.velocity * (1.0 - 2.0 * a) * std::exp(-a);
  }

private:
  RickerPulse pulse_;
};

/// Values and slopes at equal steps, joined by cubics.
class Motion::Samples final : public Motion::Shape {
public:
  Samples(double start, motion::Refined samples) : start_(start), samples_(std::move(samples)) {}

  double velocity(double t) const override {
    const double position = (t - start_) / samples_.dt;
    const std::size_t last = samples_.value.size() - 2;
    const auto i = std::min(static_cast<std::size_t>(std::max(position, 0.0)), last);
    const double s = position - static_cast<double>(i);
    const double difference = samples_.value[i + 1] - samples_.value[i];
    const double first = samples_.dt * samples_.slope[i] - difference;
    const double second = difference - samples_.dt * samples_.slope[i + 1];
    return samples_.value[i] + s * (difference + (1.0 - s) * ((1.0 - s) * first + s * second));
  }

private:
  double start_;
  motion::Refined samples_;
};

class Motion::Later final : public Motion::Shape {
public:
  Later(Motion motion, double time) : motion_(std::move(motion)), time_(time) {}

  double velocity(double t) const override { return motion_.velocity(t - time_); }

private:
  Motion motion_;
  double time_;
};

class Motion::Sum final : public Motion::Shape {
public:
  explicit Sum(std::vector<Motion> motions) : motions_(std::move(motions)) {}

  double velocity(double t) const override {
    double sum = 0.0;
    for (const Motion& motion : motions_)
      sum += motion.velocity(t);
    return sum;
  }

private:
  std::vector<Motion> motions_;
};

Motion::Motion(std::shared_ptr<const Shape> shape, double begin, double end, double highest_frequency)
    : shape_(std::move(shape)), begin_(begin), end_(end), highest_frequency_(highest_frequency) {}

double Motion::velocity(double t) const {
  return t >= begin_ && t <= end_ ? shape_->velocity(t) : 0.0;
}

Motion Motion::ricker(const RickerPulse& pulse) {
  if (!(pulse.frequency > 0.0) || !std::isfinite(pulse.frequency) || !std::isfinite(pulse.time) ||
      !std::isfinite(pulse.velocity))
    throw std::invalid_argument(
        fmt::format("Ricker pulse: frequency = {} Hz must be > 0, time = {} s and velocity = {} m/s "
                    "finite",
                    pulse.frequency, pulse.time, pulse.velocity));
  // (1 - 2a) exp(-a) = -5e-19 at a = 46.7; the spectrum f^2 exp(-(f/f0)^2) has fallen to 1e-16 at 6.5 f0.
  const double half_width = std::sqrt(46.7) / (std::numbers::pi * pulse.frequency);
  return {std::make_shared<Ricker>(pulse), pulse.time - half_width, pulse.time + half_width,
          6.5 * pulse.frequency};
}

Motion Motion::through(double start, std::span<const double> velocity, double dt) {
  return {std::make_shared<Samples>(start, motion::refined(velocity, dt, refinement)), start,
          start + static_cast<double>(velocity.size() - 1) * dt, 1.0 / dt};
}

Motion Motion::of_velocity(std::span<const double> velocity, double dt) {
  require_record(velocity, dt);
  std::vector<double> shaped(lead, 0.0);
  shaped.insert(shaped.end(), velocity.begin(), velocity.end());
  for (std::size_t i = 0; i < velocity.size() && static_cast<double>(i) * dt < rise_time; ++i)
    shaped[lead + i] *= 1.0 - falling(static_cast<double>(i) * dt / rise_time);
  const double last = shaped.back();
  for (std::size_t i = 1; i <= samples_of_fall(dt); ++i)
    shaped.push_back(last * falling(static_cast<double>(i) * dt / fall_time));
  return through(-static_cast<double>(lead) * dt, shaped, dt);
}

Motion Motion::of_acceleration(std::span<const double> acceleration, double dt) {
  require_record(acceleration, dt);
  const std::size_t fall = samples_of_fall(dt);
  auto velocity = motion::band_limited_integral(acceleration, dt, lead, fall);
  for (std::size_t i = 0; i < lead; ++i)
    velocity[i] *= 1.0 - falling(static_cast<double>(i) / static_cast<double>(lead));
  const std::size_t end = lead + acceleration.size();
  for (std::size_t i = 0; i < fall; ++i)
    velocity[end + i] *= falling(static_cast<double>(i + 1) * dt / fall_time);
  return through(-static_cast<double>(lead) * dt, velocity, dt);
}

Motion Motion::after(double time) const {
  return {std::make_shared<Later>(*this, time), begin_ + time, end_ + time, highest_frequency_};
}

Motion Motion::sum(std::vector<Motion> motions) {
  if (motions.size() == 1)
    return motions.front();
  const double begin = std::ranges::min(motions, {}, &Motion::begin).begin();
  const double end = std::ranges::max(motions, {}, &Motion::end).end();
  const double highest = std::ranges::max(motions, {}, &Motion::highest_frequency).highest_frequency();
  return {std::make_shared<Sum>(std::move(motions)), begin, end, highest};
}

SampledMotion sampled(const Motion& motion) {
  constexpr double samples_per_period = 8.0;
  SampledMotion samples{motion.begin(), 1.0 / (samples_per_period * motion.highest_frequency()), {}};
  const auto count = static_cast<std::size_t>(std::ceil((motion.end() - motion.begin()) / samples.dt)) + 1;
  samples.velocity.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    samples.velocity.push_back(motion.velocity(samples.time(i)));
  return samples;
}

namespace {

Motion from_its_own_start(const MotionSource& source) {
  if (const auto* pulse = std::get_if<RickerPulse>(&source))
    return Motion::ricker(*pulse);
  const auto& file = std::get<MotionFile>(source);
  motion::Record record = motion::read_record(file.path, file.as);
  const bool accelerations = record.quantity() == motion::Quantity::acceleration;
  record = motion::with_unit(record, accelerations ? motion::Unit::m_s2 : motion::Unit::m_s);
  for (double& sample : record.samples)
    sample *= file.scale;
  return accelerations ? Motion::of_acceleration(record.samples, record.dt)
                       : Motion::of_velocity(record.samples, record.dt);
}

} // namespace

Motion motion(const ShakingMotion& shaking) {
  const Motion own = from_its_own_start(shaking.source);
  return shaking.start > 0.0 ? own.after(shaking.start) : own;
}

Motion motion(const MotionInput& input) {
  std::vector<Motion> motions;
  for (const ShakingMotion& shaking : input.shakings)
    motions.push_back(motion(shaking));
  return Motion::sum(std::move(motions));
}

double highest_frequency(const Case& scene) {
  double highest = 0.0;
  for (const MotionInput* wave : scene.plane_waves())
    highest = std::max(highest, motion(*wave).highest_frequency());
  return highest;
}

} // namespace tremolo::scene
