#include "scene/plan/motion.hpp"

#include "motion/read/read.hpp"

#include <fmt/format.h>
#include <gsl/gsl_spline.h>

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

/// Half a cosine from 1 at s = 0 to 0 at s = 1.
double falling(double s) {
  return 0.5 * (1.0 + std::cos(std::numbers::pi * std::clamp(s, 0.0, 1.0)));
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

class Motion::Spline final : public Motion::Shape {
public:
  Spline(const std::vector<double>& velocity, double dt)
      : spline_(gsl_spline_alloc(gsl_interp_cspline, velocity.size()), gsl_spline_free) {
    if (!spline_)
      throw std::bad_alloc();
    std::vector<double> times(velocity.size());
    for (std::size_t i = 0; i < times.size(); ++i)
      times[i] = static_cast<double>(i) * dt;
    gsl_spline_init(spline_.get(), times.data(), velocity.data(), velocity.size());
  }

  double velocity(double t) const override { return gsl_spline_eval(spline_.get(), t, nullptr); }

private:
  std::unique_ptr<gsl_spline, decltype(&gsl_spline_free)> spline_;
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

Motion Motion::record(std::span<const double> velocity, double dt) {
  const auto finite = [](double v) { return std::isfinite(v); };
  if (velocity.size() < 2 || !(dt > 0.0) || !std::isfinite(dt) || !std::ranges::all_of(velocity, finite))
    throw std::invalid_argument(
        fmt::format("a record of velocities needs at least 2 finite samples and dt > 0, has {} and dt = "
                    "{} s",
                    velocity.size(), dt));
  std::vector<double> shaped(velocity.begin(), velocity.end());
  for (std::size_t i = 0; i < shaped.size() && static_cast<double>(i) * dt < rise_time; ++i)
    shaped[i] *= 1.0 - falling(static_cast<double>(i) * dt / rise_time);
  const auto tail = static_cast<std::size_t>(std::ceil(fall_time / dt));
  const double last = shaped.back();
  for (std::size_t i = 1; i <= std::max<std::size_t>(tail, 2); ++i)
    shaped.push_back(last * falling(static_cast<double>(i) * dt / fall_time));
  const double end = static_cast<double>(shaped.size() - 1) * dt;
  return {std::make_shared<Spline>(shaped, dt), 0.0, end, 1.0 / dt};
}

Motion motion(const MotionInput& input) {
  if (const auto* pulse = std::get_if<RickerPulse>(&input.source))
    return Motion::ricker(*pulse);
  const auto& file = std::get<MotionFile>(input.source);
  auto record = motion::with_unit(motion::read_record(file.path, file.as), motion::Unit::m_s);
  for (double& sample : record.samples)
    sample *= file.scale;
  return Motion::record(record.samples, record.dt);
}

} // namespace tremolo::scene
