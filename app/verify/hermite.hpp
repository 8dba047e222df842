#pragma once

namespace tremolo::app {

/// A quantity and its time derivative.
struct Jet {
  double value = 0.0;
  double rate = 0.0;
};

/// Cubic Hermite interpolation between the ends of an interval dt, s = t/dt in [0, 1].
inline Jet hermite(Jet begin, Jet end, double dt, double s) {
  const double rise = end.value - begin.value;
  const double u = 1.0 - s;
  return {
      .value = begin.value + s * s * (3.0 - 2.0 * s) * rise + dt * s * u * (u * begin.rate - s * end.rate),
      .rate = 6.0 * s * u * rise / dt + u * (1.0 - 3.0 * s) * begin.rate + s * (3.0 * s - 2.0) * end.rate};
}

} // namespace tremolo::app
