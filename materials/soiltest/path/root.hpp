#pragma once

// A root of a function that is costly and may jump: bracketed by steps along its expected slope, then Brent's
// method (GSL).

#include <functional>

namespace tremolo::soiltest {

struct RootSearch {
  double guess = 0.0;
  double least = 0.0; ///< never outside of these
  double most = 0.0;
  double slope = 1.0;     ///< expected, not zero
  double tolerance = 0.0; ///< of the root
};

/// The point at which a function changes sign. At a jump it is the side on which the function is smaller.
struct Root {
  bool found = false; ///< otherwise x is the point with the smallest value
  double x = 0.0;
  double value = 0.0;
  int evaluations = 0;
};

/// @throws what the function throws
Root find_root(const std::function<double(double)>& function, const RootSearch& search);

} // namespace tremolo::soiltest
