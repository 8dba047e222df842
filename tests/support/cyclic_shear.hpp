#pragma once

#include "materials/law/driver.hpp"

#include <cmath>

namespace tremolo::testing {

/// Direct simple shear at constant volume to and fro between two shear stresses, in increments of strain; the
/// one that would pass the turning stress is bisected to end there. Starts towards positive stress.
class CyclicShear {
public:
  /// @param amplitude, bias  shear stress turns at bias +- amplitude, Pa
  /// @param increment  engineering shear strain
  CyclicShear(materials::PointTest& point, double amplitude, double bias, double increment)
      : point_(point), amplitude_(amplitude), bias_(bias), increment_(increment) {}

  void step() {
    const materials::PointState before = point_.now();
    const auto beyond = [&](double strain) {
      using materials::Control;
      point_.set(before);
      point_.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(direction_ * strain)});
      return direction_ * (point_.stress().xy - bias_) > amplitude_;
    };
    const bool turns = beyond(increment_);
    if (turns) {
      double low = 0.0;
      double high = increment_;
      for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (low + high);
        (beyond(middle) ? high : low) = middle;
      }
    }
    const double way = 0.5 * (1.0 + direction_ * (point_.stress().xy - bias_) / amplitude_); // 0 to 1
    cycle_ = half_cycles_ == 0 ? 0.25 * (2.0 * way - 1.0) : 0.25 + 0.5 * (half_cycles_ - 1 + way);
    if (turns) {
      ++half_cycles_;
      direction_ = -direction_;
    }
  }

  /// Cycles so far, in proportion to the stress within a half cycle.
  double cycle() const { return cycle_; }

private:
  materials::PointTest& point_;
  double amplitude_;
  double bias_;
  double increment_;
  double direction_ = 1.0;
  double cycle_ = 0.0;
  int half_cycles_ = 0; ///< the first one is a quarter cycle
};

} // namespace tremolo::testing
