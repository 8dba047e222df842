#pragma once

#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/spec/plot.hpp"

#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

/// Makes particles of plots. What is too little for one (is_particle) goes to the nearest particle of its set
/// once all are there; that one stays where it is, so that its box reaches no farther out.
class Plots {
public:
  /// Adds a particle without stress, with the density of its set, or keeps the sliver for later.
  /// @param size  of the square that the plot is part of, m
  void add(Particles& set, const Plot& plot, double size);
  /// Shares the slivers out; the sets must not have moved.
  void join_slivers();

private:
  std::vector<std::pair<Particles*, Plot>> slivers_;
};

} // namespace tremolo::mpm_domain
