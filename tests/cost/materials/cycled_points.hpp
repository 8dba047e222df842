#pragma once

// Points sheared to and fro at constant volume, for the cost of a law: a triangle of given amplitude, begun
// anew from the initial stress every four cycles or 20,000 updates. Points start their cycles at different
// strains, so that at every step some of them reverse.

#include "materials/law/law.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tremolo::materials {

class CycledPoints {
public:
  /// @param amplitude, increment  engineering shear strain
  /// @param vertical  initial vertical stress, Pa, tension positive; the horizontal one is half of it
  /// @param rotation  increment of every step, rad
  CycledPoints(const Law& law, std::size_t count, double amplitude, double increment, double vertical,
               double rotation = 0.0)
      : law_(law), amplitude_(amplitude), vertical_(vertical), stress_(4 * count),
        state_(count * state_variables(law).size()), work_(count), zero_(count), rotation_(count, rotation),
        shear_(count), position_(count) {
    points_.count = count;
    points_.sxx = stress_.data();
    points_.syy = points_.sxx + count;
    points_.szz = points_.syy + count;
    points_.sxy = points_.szz + count;
    points_.state = state_.data();
    points_.plastic_work = work_.data();
    points_.dexx = points_.deyy = zero_.data();
    points_.dwxy = rotation_.data();
    points_.dgxy = shear_.data();
    std::fill(shear_.begin(), shear_.end(), increment);
    const double path = 16.0 * amplitude / increment;
    last_step_ = static_cast<long>(std::min(path, 20000.0));
    restart();
  }

  /// One update of all points; the rest of it costs a nanosecond a point.
  void step() {
    if (++step_ > last_step_) {
      restart();
    }
    for (std::size_t i = 0; i < position_.size(); ++i) {
      if (std::abs(position_[i] + shear_[i]) > amplitude_) {
        shear_[i] = -shear_[i];
      }
      position_[i] += shear_[i];
    }
    update(law_, points_);
  }

private:
  void restart() {
    for (std::size_t i = 0; i < position_.size(); ++i) {
      points_.sxx[i] = points_.szz[i] = 0.5 * vertical_;
      points_.syy[i] = vertical_;
      points_.sxy[i] = 0.0;
      position_[i] = amplitude_ * static_cast<double>(i % 100) / 100.0;
      shear_[i] = std::abs(shear_[i]);
    }
    initialise(law_, points_);
    step_ = 0;
  }

  Law law_;
  double amplitude_;
  double vertical_;
  long step_ = 0;
  long last_step_ = 0;
  std::vector<double> stress_, state_, work_, zero_, rotation_;
  std::vector<double> shear_;    ///< increment of each point
  std::vector<double> position_; ///< strain of each point
  Points points_;
};

} // namespace tremolo::materials
