#pragma once

// Assigns nodes to clocks. A node belongs to the fastest clock among the particles that touch it, directly or
// through a tie: slower particles give it mass and an impulse now and then, and between their steps read it
// as a mean. With one clock all nodes that soil may touch are its own.

#include "mpm_domain/fields/saved_numbers.hpp"
#include "mpm_domain/ground.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

class ClockNodes {
public:
  /// Takes the particles' blocks of the last sort and holds wherever particles move until the next one.
  explicit ClockNodes(const Ground& ground);

  /// Real nodes of a clock, by rows.
  std::span<const NodeRange> of(int clock) const { return of_[static_cast<std::size_t>(clock)]; }
  /// Real nodes of a clock and of all faster ones.
  std::span<const NodeRange> from(int clock) const { return from_[static_cast<std::size_t>(clock)]; }
  /// Real nodes of faster clocks that particles of this clock or a slower one touch too.
  std::span<const NodeRange> shared(int clock) const { return shared_[static_cast<std::size_t>(clock)]; }
  /// Rows of the prolongation whose tied nodes the particles of a clock touch.
  std::span<const std::size_t> ties_of(int clock) const { return ties_[static_cast<std::size_t>(clock)]; }
  /// The clock of a real node; -1 if there are several clocks and no particle touches the node.
  int clock_of(std::size_t node) const { return one_clock() ? 0 : static_cast<int>(clock_[node]) - 1; }
  bool one_clock() const { return clock_.empty(); }

  /// State that a checkpoint stores (state.hpp).
  template <class Writer>
  void save(Writer& to) const {
    write_integers(to, "clock_nodes.clock", clock_);
    write_integers(to, "clock_nodes.slowest", slowest_);
    for (std::size_t clock = 0; clock < ties_.size(); ++clock)
      write_integers(to, "clock_nodes.ties" + std::to_string(clock), ties_[clock]);
  }
  /// @throws std::runtime_error for clocks of another grid
  template <class Reader>
  void restore(const Ground& ground, const Reader& from) {
    read_integers(from, "clock_nodes.clock", clock_);
    read_integers(from, "clock_nodes.slowest", slowest_);
    for (std::size_t clock = 0; clock < ties_.size(); ++clock)
      read_integers(from, "clock_nodes.ties" + std::to_string(clock), ties_[clock]);
    require_fit(ground);
    collect(ground);
  }

private:
  class Builder;
  void require_fit(const Ground& ground) const;
  void take_clocks_of_all(const Ground& ground);
  void collect(const Ground& ground);

  std::vector<std::uint32_t> clock_;   ///< 1 + the clock, or 0; empty with one clock
  std::vector<std::uint32_t> slowest_; ///< of the particles that touch a node, likewise
  std::vector<std::vector<NodeRange>> of_, from_, shared_;
  std::vector<std::vector<std::size_t>> ties_;
};

} // namespace tremolo::mpm_domain
