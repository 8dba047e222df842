#pragma once

// A blow in the ground, as initial velocities: waves of all angles, and nothing from outside.

#include "tests/support/box_run.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

namespace tremolo::test_support {

/// Ground that has been struck at t = 0.
struct StruckGround {
  /// @param place from the middle of the surface, m
  explicit StruckGround(const mpm_domain::Spec& spec, eq6::Vector position = {0.0, -8.0})
      : domain(spec), stepper(struck(domain, position), 0.0, quiet_ground()), watched_(watched(domain)) {}

  /// Velocities of the particles in the middle of the ground at a time, in the order of their first places.
  void see() {
    for (const Particle& particle : watched_) {
      const mpm_domain::Particles& set = domain.sets[particle.set];
      const std::size_t k = set.index_of[particle.id];
      seen.insert(seen.end(), {set.vx[k], set.vy[k]});
    }
  }

  mpm_domain::Domain domain;
  mpm_domain::Stepper stepper;
  std::vector<double> seen; ///< m/s

private:
  struct Particle {
    long row, column; ///< of its first place, 1/64 m
    std::size_t set;
    std::uint32_t id;
    bool operator<(const Particle& other) const {
      return std::tie(row, column) < std::tie(other.row, other.column);
    }
  };

  static double middle(const mpm_domain::Spec& spec) { return 0.5 * (spec.box.x_min + spec.box.x_max); }

  static mpm_domain::Domain& struck(mpm_domain::Domain& domain, eq6::Vector position) {
    for (mpm_domain::Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k) {
        const double dx = set.x[k] - middle(domain.spec) - position.x, dy = set.y[k] - position.y;
        set.vx[k] = 0.1 * std::exp(-(dx * dx + dy * dy) / 9.0);
      }
    return domain;
  }

  static std::vector<Particle> watched(const mpm_domain::Domain& domain) {
    std::vector<Particle> found;
    for (std::size_t s = 0; s < domain.sets.size(); ++s) {
      const mpm_domain::Particles& set = domain.sets[s];
      for (std::size_t k = 0; k < set.size(); ++k)
        if (const double x = set.x[k] - middle(domain.spec); std::abs(x) < 15.0 && set.y[k] > -15.0)
          found.push_back({std::lround(64.0 * set.y[k]), std::lround(64.0 * x), s, set.id[k]});
    }
    std::ranges::sort(found, std::less<>{});
    return found;
  }

  std::vector<Particle> watched_;
};

/// Velocities of the particles around a blow, one sample in twenty steps.
/// @param duration  of the run, s
/// @param place  as of StruckGround
inline std::vector<double> seen_after_a_blow(const mpm_domain::Spec& spec, double duration,
                                             eq6::Vector position = {0.0, -8.0}) {
  StruckGround run(spec, position);
  while (run.stepper.time() < duration) {
    run.stepper.step();
    if (run.stepper.steps() % 20 == 0)
      run.see();
  }
  return run.seen;
}

inline double relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double error = 0.0;
  double norm = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    error += std::pow(a[i] - b[i], 2);
    norm += b[i] * b[i];
  }
  return std::sqrt(error / norm);
}

} // namespace tremolo::test_support
