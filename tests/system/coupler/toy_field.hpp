#pragma once

// The free field that toy sources serve and the motion of the toy domain, in closed form: an upgoing SV wave,
// tilted by the horizontal slowness, and its shear stress.

#include "coupler/wire/field.hpp"

#include <cmath>
#include <span>
#include <vector>

namespace tremolo::coupler::toy {

/// A step deadline that is waited for, s. Instrumented processes take longer over their first steps.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr double brief = 5.0;
#else
inline constexpr double brief = 1.0;
#endif

inline constexpr double omega = 9.0;   // rad/s
inline constexpr double speed = 100.0; // vertical phase velocity, m/s
inline constexpr double impedance = 1e5;

inline FieldDescription field(const std::string& name) {
  FieldDescription field{.name = name,
                         .x_reference = -20.0,
                         .slowness_x = 2e-3,
                         .start_time = -0.5,
                         .time_step = 0.01,
                         .step_count = 400};
  for (int i = 0; i <= 80; ++i)
    field.y.push_back(-40.0 + 0.5 * i);
  return field;
}

/// On the profile, i.e. at x_reference.
inline eq6::FreeField motion(double y, double t) {
  const double v = std::sin(omega * (t - y / speed));
  return {{v, -0.5 * v}, {0.1 * impedance * v, 0.2 * impedance * v, -impedance * v}};
}

inline void fill(const FieldDescription& field, std::uint64_t step, std::span<double> values) {
  auto out = values.begin();
  for (const double y : field.y) {
    const double t = field.time(step);
    // The derivative of sin is sin a quarter of a period earlier.
    const auto now = motion(y, t);
    const auto rate = motion(y, t + std::acos(-1.0) / 2.0 / omega);
    for (const double value : {now.velocity.x, now.velocity.y, now.stress.xx, now.stress.yy, now.stress.xy})
      *out++ = value;
    for (const double value :
         {rate.velocity.x, rate.velocity.y, rate.stress.xx, rate.stress.yy, rate.stress.xy})
      *out++ = omega * value;
  }
}

/// Left, right and lower edge of a box of 40 m x 40 m.
inline std::vector<ExchangedFace> faces() {
  std::vector<ExchangedFace> list;
  for (int i = 0; i < 40; ++i) {
    const double s = -39.5 + i;
    list.push_back({{-20.0, s}, {{-1.0, 0.0}, 3e5, 1e5}, {1e4 * s, 0.0}, "left", "total"});
    list.push_back({{20.0, s}, {{1.0, 0.0}, 3e5, 1e5}, {-1e4 * s, 0.0}, "right", "total"});
    list.push_back({{s + 20.0, -40.0}, {{0.0, -1.0}, 3e5, 1e5}, {0.0, 4e5}, "left", "incident"});
  }
  return list;
}

inline constexpr int steps = 300;

/// Not uniform: the domain's time step varies.
inline double time(int step) {
  return 0.007 * step + 0.001 * std::sin(step);
}

inline eq6::Vector domain_velocity(std::size_t face, int step) {
  return {std::sin(0.1 * step + static_cast<double>(face)), std::cos(0.2 * step - static_cast<double>(face))};
}

} // namespace tremolo::coupler::toy
