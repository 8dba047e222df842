#pragma once

// A load that changes with time: a layer of dry soil whose mass grows, as an embankment does.

#include "mpm_domain/domain.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace tremolo::test_support {

/// From 0 to 1 as s goes there, with no jump of velocity or acceleration.
inline double smooth_step(double s) {
  const double x = std::clamp(s, 0.0, 1.0);
  return x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
}

/// The dry soil of one name.
class GrowingLoad {
public:
  GrowingLoad(mpm_domain::Domain& domain, std::string_view soil) {
    for (mpm_domain::Particles& set : domain.sets)
      if (set.soil == soil && set.size() > 0)
        layers_.push_back({&set, set.mass.front()}); // all its particles are of one size
  }

  /// @param factor  on the mass that it had at first
  void grow(double factor) const {
    for (const auto& [set, mass] : layers_)
      std::ranges::fill(set->mass, factor * mass);
  }

private:
  struct Layer {
    mpm_domain::Particles* set;
    double mass; ///< of a particle at first, kg/m
  };

  std::vector<Layer> layers_;
};

} // namespace tremolo::test_support
