#pragma once

// Particles of a set on their way between ranks. They go by quantities, as many at a time as are little
// beside a rank's share, so that no rank has the fields of its particles twice.
//
// The particles of a block come from one rank, in their order. So those of all ranks are in order again when
// they stand block by block.

#include "mpm_domain/particles/particles.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace tremolo::mpm_domain {

class Communicator;

/// Numbers that go with a particle besides its own: as many for each.
struct Luggage {
  std::size_t count = 0;
  /// Adds those of particle k.
  std::function<void(std::size_t k, std::vector<double>& to)> add = {};
};

class Journey {
public:
  /// Quarters of particles that have been cut since the last sort stand in a block behind all others.
  /// @param ranks  all of which make the journey
  /// @param from   the set; it outlives this
  explicit Journey(Communicator& ranks, const Particles& from);

  /// A particle goes to a rank. They are to be named as they stand in the set; one may go to several.
  void go(std::size_t k, int rank);
  /// A particle stays.
  void stay(std::size_t k) { staying_.push_back(static_cast<std::uint32_t>(k)); }

  /// Particles of all ranks that are on the way.
  std::size_t count() const;

  /// Leaves a set of the same kind, or the one they go from, with those that stay and those that come.
  /// @param blocks  in which they stand then
  /// @returns the numbers that go with those that have come, particle after particle
  std::vector<double> arrive(Particles& at, std::size_t blocks, const Luggage& luggage = {});

private:
  struct Traveller {
    std::uint32_t k;
    std::uint32_t block;
  };
  /// One that has come: its block, and which it is of all that have.
  struct Arrival {
    std::uint32_t block;
    std::uint32_t number;
  };
  using Lists = std::vector<std::vector<double>>; ///< by rank

  /// Those that are there then, in order.
  struct Arrived {
    std::vector<std::uint32_t> sources; ///< a place in the set; from size_ on, which of those that have come
    std::vector<std::uint32_t> ids;
    std::vector<std::size_t> block_start;
  };

  std::uint32_t block_of(std::size_t k);
  /// Numbers of those that leave, rank by rank, go to the ranks and come from them.
  /// @param add  (particle, list) adds those of one
  template <typename Add>
  Lists exchange(const Add& add) const;
  Arrived in_order(const std::vector<double>& heads, std::size_t blocks) const;
  std::size_t columns_at_once(std::size_t columns) const;
  void bring_columns(const std::vector<std::uint32_t>& sources, Particles& at) const;
  std::vector<double> bring(const Luggage& luggage, const std::vector<std::uint32_t>& sources) const;

  Communicator& ranks_;
  const Particles& from_;
  std::uint32_t size_;                     ///< of the set, before anybody has left
  std::vector<std::vector<Traveller>> to_; ///< by rank
  std::vector<std::uint32_t> staying_;
  std::size_t block_ = 0; ///< of the particle named last
};

} // namespace tremolo::mpm_domain
