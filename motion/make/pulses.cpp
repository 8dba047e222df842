#include "motion/make/pulses.hpp"

#include "motion/read/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::motion {

namespace {

constexpr double pi = std::numbers::pi;

double squared_sinc(double x) {
  const double y = pi * x;
  return std::abs(y) < 1e-8 ? 1.0 : std::pow(std::sin(y) / y, 2);
}

double ormsby(const std::array<double, 4>& f, double tau) {
  const auto ramp = [tau](double p, double q) {
    return pi / (p - q) * (p * p * squared_sinc(p * tau) - q * q * squared_sinc(q * tau));
  };
  return (ramp(f[3], f[2]) - ramp(f[1], f[0])) / (pi * (f[3] + f[2] - f[1] - f[0]));
}

double ricker(double frequency, double tau) {
  const double a = std::pow(pi * frequency * tau, 2);
  return (1.0 - 2.0 * a) * std::exp(-a);
}

/// Distance to the nearer end as a part of the ramp, 1 between the ramps.
double ramp(const Pulse& pulse, double cycle) {
  if (pulse.ramp_cycles == 0.0)
    return 1.0;
  return std::clamp(std::min(cycle, pulse.cycles - cycle) / pulse.ramp_cycles, 0.0, 1.0);
}

double sines(const Pulse& pulse, double tau) {
  const double cycle = pulse.frequency * tau;
  if (cycle < 0.0 || cycle > pulse.cycles)
    return 0.0;
  const double sine = std::sin(2.0 * pi * cycle);
  const double s = ramp(pulse, cycle);
  switch (pulse.shape) {
  case PulseShape::tapered_sine:
    return 0.5 * (1.0 - std::cos(pi * s)) * sine;
  case PulseShape::centrifuge:
    return s * (sine + pulse.third_harmonic * std::sin(6.0 * pi * cycle));
  default:
    return sine;
  }
}

void refuse_unless(bool sound, const char* what) {
  if (!sound)
    throw std::invalid_argument(fmt::format("pulse: {}", what));
}

} // namespace

void require_sound(const Pulse& pulse) {
  refuse_unless(std::isfinite(pulse.amplitude) && std::isfinite(pulse.time),
                "amplitude and time must be finite");
  if (pulse.shape == PulseShape::ormsby) {
    const auto& f = pulse.corners;
    refuse_unless(f[0] >= 0.0 && f[0] < f[1] && f[1] < f[2] && f[2] < f[3] && std::isfinite(f[3]),
                  "corners must rise: 0 <= f1 < f2 < f3 < f4 (Hz)");
    return;
  }
  refuse_unless(pulse.frequency > 0.0 && std::isfinite(pulse.frequency), "frequency must be > 0 Hz");
  if (pulse.shape == PulseShape::ricker)
    return;
  refuse_unless(pulse.cycles > 0.0 && std::isfinite(pulse.cycles), "cycles must be > 0");
  refuse_unless(pulse.ramp_cycles >= 0.0 && 2.0 * pulse.ramp_cycles <= pulse.cycles,
                "ramp_cycles must be from 0 to half the cycles");
  refuse_unless(pulse.third_harmonic >= 0.0 && pulse.third_harmonic <= 1.0,
                "third_harmonic must be from 0 to 1");
}

double value(const Pulse& pulse, double t) {
  const double tau = t - pulse.time;
  switch (pulse.shape) {
  case PulseShape::ricker:
    return pulse.amplitude * ricker(pulse.frequency, tau);
  case PulseShape::ormsby:
    return pulse.amplitude * ormsby(pulse.corners, tau);
  default:
    return pulse.amplitude * sines(pulse, tau);
  }
}

Record sampled(const Pulse& pulse, Unit unit, double dt, std::size_t count) {
  require_sound(pulse);
  if (!(dt > 0.0) || !std::isfinite(dt) || count < 2 || static_cast<double>(count) > most_samples)
    throw std::invalid_argument(fmt::format(
        "a pulse of {} samples every {} s: from 2 to {:g} samples, dt > 0", count, dt, most_samples));
  Record record{.unit = unit, .dt = dt};
  record.samples.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    record.samples.push_back(value(pulse, static_cast<double>(i) * dt));
  return record;
}

} // namespace tremolo::motion
