#pragma once

// The surface of soil over x: the top of the highest particle in each column that is as wide as the widest of
// them.

#include "base/vector.hpp"

#include <map>

namespace tremolo::mpm_domain {

class SurfaceLine {
public:
  /// @param width  of the widest particle, m
  explicit SurfaceLine(double width) : width_(width) {}

  /// @param size  a side of the particle, m
  void add(Vector position, double size);

  /// y at x, m; where two columns meet that of the lower one, and where there is no soil minus infinity.
  double at(double x) const;

private:
  double width_;
  std::map<long, double> tops_; ///< by the number of the column
};

} // namespace tremolo::mpm_domain
