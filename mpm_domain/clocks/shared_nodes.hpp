#pragma once

// Nodes that particles of several clocks share. Clock r ticks every dt_r = dt_0/2^r, and a particle belongs
// to one clock (clock_map.hpp). Forces of slow particles act as an impulse dt_q f_q at the start of their
// step, while what is faster goes on,
//
//     m (v+ - v-) = sum over the clocks q that begin a step now: dt_q f_q,        dx/dt = v+,
//
// which is the impulse method (r-RESPA: Tuckerman, Berne and Martyna 1992; asynchronous variational
// integrators: Lew, Marsden, Ortiz and West 2003), symplectic with one step size per clock, on a partition of
// particles: a force is one particle's, pulls its nodes with equal and opposite impulses, and momentum is
// conserved to rounding.
//
// The slow force of the first step after a sort, mostly that of the soil's weight, gives no impulses but acts
// at every tick,
//
//     at each tick dt_r f_0, and at the start of the step dt_q (f_q - f_0):        dt_q f_q in all.
//
// Soil at rest under its weight thus stays there: whole impulses would shake it by dt_q f_q/m.
//
// Particles bring mass and momentum to the grid at the start of their step. A shared node moves on the
// fastest of its clocks and keeps what the slow ones brought until their step ends,
//
//     m_q constant,      p_q <- m_q v+,
//
// and the slow particles then read the velocity after its last update and, to move and to strain, the mean of
// its velocities over their step. A mean over the step of clock q is the half sum of the means over the two
// steps of clock q + 1 in it. Sums p_q, m_q are kept over clocks 0 to q, which is what a step that begins
// with clock q + 1 finds on its nodes.

#include "mpm_domain/clocks/clock_nodes.hpp"
#include "mpm_domain/clocks/ticks.hpp"

#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// State that shared nodes keep during the steps of slow clocks; empty with one clock.
class SharedNodes {
public:
  SharedNodes(Ground& ground, const Ticks& ticks, const ClockNodes& nodes);

  /// After a sort: all that was kept is zero.
  void restart();

  /// The nodes that are due start with what slower particles brought: mass and momentum, or momentum alone.
  void take_masses(int first_due);
  void take_momenta(int first_ending);
  /// A clock's particles have been scattered and their ties folded: their nodes remember what this and slower
  /// clocks brought, and their forces are turned into impulses of the next faster clock.
  void keep(int clock);
  /// After the last clock: steady forces act at every tick.
  void add_steady();
  /// After the update: what the nodes still hold of slow particles moves with them.
  void follow_update();
  /// Mean velocities over the step of a clock take the place of the last ones; those of the next slower clock
  /// take their half of them.
  void take_mean(int clock);
  void add_mean(int clock);
  /// Computes, for output, accelerations averaged over the step of the slowest particles that share a node.
  void mean_accelerations();

  /// State that a checkpoint stores between steps (state.hpp).
  template <class Writer>
  void save(Writer& to) const {
    to.write("shared_nodes.steady_known", std::vector<double>{steady_known_ ? 1.0 : 0.0});
    for (std::size_t clock = 0; clock < kept_.size(); ++clock) {
      to.write("shared_nodes.steady_x" + std::to_string(clock), kept_[clock].steady_x);
      to.write("shared_nodes.steady_y" + std::to_string(clock), kept_[clock].steady_y);
    }
  }
  /// @throws std::runtime_error for what was kept for another grid
  template <class Reader>
  void restore(const Reader& from) {
    steady_known_ = from.numbers("shared_nodes.steady_known").at(0) != 0.0;
    for (std::size_t clock = 0; clock < kept_.size(); ++clock) {
      kept_[clock].steady_x = from.numbers("shared_nodes.steady_x" + std::to_string(clock));
      kept_[clock].steady_y = from.numbers("shared_nodes.steady_y" + std::to_string(clock));
    }
    require_fit();
    clear_step();
  }

private:
  /// State of one clock; all fields cover all nodes of the grid.
  struct Kept {
    std::vector<double> mass, momentum_x, momentum_y; ///< of the particles of this and all slower clocks
    std::vector<double> steady_x, steady_y;           ///< of this one's forces, N/m
    std::vector<double> change_x, change_y;           ///< sum of v+ - v-
    std::vector<double> vx_strain, vy_strain;         ///< mean of the velocity that strains
    std::vector<double> vx_after, vy_after;           ///< mean of v+
  };

  void require_fit() const;
  void clear_step();
  /// Whether faster clocks may share nodes of this one.
  bool shares(int clock) const { return clock + 1 < ticks_.clocks(); }
  Kept& of(int clock) { return kept_[static_cast<std::size_t>(clock)]; }
  template <typename Act>
  void over(std::span<const NodeRange> rows, const Act& act);

  Ground& ground_;
  const Ticks& ticks_;
  const ClockNodes& nodes_;
  std::vector<Kept> kept_;
  bool steady_known_ = false; ///< once the first step after a sort has found the steady forces
};

} // namespace tremolo::mpm_domain
