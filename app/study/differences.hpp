#pragma once

// The difference of two motions v and r, relative to r,
//
//   sqrt( sum |v - r|^2 / sum |r|^2 )
//
// At a monitor the sum runs over the times of the reference r; between its own rows v is the cubic Hermite
// interpolant of velocity and acceleration. A monitor follows the particle nearest to its point, which on
// another mesh lies up to half a cell elsewhere.

#include "results/run_file.hpp"

#include <string>

namespace tremolo::app {

/// The two sums.
struct Squares {
  double difference = 0.0;
  double reference = 0.0;

  void add(double value, double expected) {
    difference += (value - expected) * (value - expected);
    reference += expected * expected;
  }
  double relative() const; ///< 0 where the reference is at rest
};

/// Compares the particle velocity at a monitor.
/// @throws std::runtime_error where it is missing or has no history
Squares difference_at(const std::string& monitor, const results::RunReader& run,
                      const results::RunReader& reference);

/// The relative difference over all monitors of the reference.
/// @throws std::runtime_error also where they are at rest throughout
double difference_at_monitors(const results::RunReader& run, const results::RunReader& reference);

} // namespace tremolo::app
