#pragma once

// Stretch of the depth z in a matched layer (layer_lattice.hpp):
//
//     g(z, omega) = 1 + b(z)/(a + i omega),        b = b_max (z/d)^2,
//
// and the decay of its memory variables: dM/dt = s - r M, in steps of dt, centred,
//
//     M+ = (1 - r dt/2)/(1 + r dt/2) M- + dt/(1 + r dt/2) s.

#include <cmath>

namespace tremolo::mpm_domain {

/// Decay of a memory variable with rate r (1/s) in a step of dt (s).
struct Decay {
  double keep;
  double gain;

  Decay(double rate, double dt)
      : keep((1.0 - 0.5 * rate * dt) / (1.0 + 0.5 * rate * dt)), gain(dt / (1.0 + 0.5 * rate * dt)) {}
};

/// The stretch at one depth, and how the memory Q decays there.
struct StretchAt {
  double rate; ///< b, 1/s
  Decay decay;
};

/// The stretch of a layer of a depth (m), for waves of up to a speed (m/s). Layers that meet at a corner
/// share both.
class LayerStretch {
public:
  LayerStretch() = default;
  LayerStretch(double depth, double fastest)
      : depth_(depth), largest_(-1.5 * fastest * std::log(returned) / depth),
        shift_(shift_of_depth * fastest / depth) {}

  [[nodiscard]] double rate(double z) const { return largest_ * (z / depth_) * (z / depth_); } ///< b, 1/s
  /// The stretch at a depth z, for steps of dt (s).
  [[nodiscard]] StretchAt at(double z, double dt) const { return {rate(z), Decay(shift_ + rate(z), dt)}; }
  [[nodiscard]] double shift() const { return shift_; } ///< a, 1/s

private:
  /// Remaining amplitude of a P wave after travelling to the fixed end and back along the normal. A smaller
  /// value would need a steeper stretch, which the elements reflect (docs/boundaries.md).
  static constexpr double returned = 1e-3;
  /// a d/c_p: waves far slower than 1/a are let through to the fixed end, which then is 70 d away.
  static constexpr double shift_of_depth = 0.05;

  double depth_ = 1.0;
  double largest_ = 0.0; ///< b_max, 1/s
  double shift_ = 0.0;   ///< a, 1/s
};

/// Takes a memory of half a step before the present to half a step behind it.
/// @returns their mean, which is what it is at present
template <typename Vector>
Vector remember(Vector& memory, const Decay& decay, const Vector& now) {
  const Vector before = memory;
  memory = {decay.keep * before.x + decay.gain * now.x, decay.keep * before.y + decay.gain * now.y};
  return {0.5 * (before.x + memory.x), 0.5 * (before.y + memory.y)};
}

} // namespace tremolo::mpm_domain
