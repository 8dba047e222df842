#pragma once

#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/spec/plot.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

class Communicator;

/// Makes particles of plots. What is too little for one (is_particle) goes to the nearest particle of its set
/// once all are there; that one stays where it is, so that its box reaches no farther out.
class Plots {
public:
  /// @param sets   that take the particles; they outlive this
  /// @param ranks  those that fill together, each its part; null: there are no others
  explicit Plots(std::span<Particles> sets, Communicator* ranks = nullptr);

  /// Adds a particle without stress, with the density of its set, or keeps the sliver for later.
  /// @param size  of the square that the plot is part of, m
  void add(std::size_t set, const Plot& plot, double size);
  /// Shares the slivers out; the sets must not have moved. All ranks call it.
  void join_slivers();

private:
  struct Sliver {
    std::size_t set;
    Plot plot;
    int rank; ///< that has laid it
  };
  /// The particle that is next to a sliver.
  struct Nearest {
    std::size_t k = 0;
    double distance; ///< m; infinite: there is none
  };

  void begin_empty_sets();
  Nearest nearest(const Sliver& sliver) const;

  std::span<Particles> sets_;
  Communicator* ranks_;
  int rank_;
  std::vector<Sliver> slivers_;
};

} // namespace tremolo::mpm_domain
