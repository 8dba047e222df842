#pragma once

// Steps of their own for the levels of a graded mesh: clock r ticks every dt_r = dt_0/2^r, and a particle
// belongs to one clock (graded/clock_map.hpp). Forces of slow particles act as an impulse dt_q f_q at the
// start of their step, while what is faster goes on,
//
//     m (v+ - v-) = sum over the clocks q that begin a step now: dt_q f_q,        dx/dt = v+,
//
// which is the impulse method (r-RESPA: Tuckerman, Berne and Martyna 1992; asynchronous variational
// integrators: Lew, Marsden, Ortiz and West 2003), symplectic with one step size per clock, on a partition of
// particles: a force is one particle's, pulls its nodes with equal and opposite impulses, and momentum is
// conserved to rounding.
//
// What a slow force was at the first step after a sort, mostly that of the soil's weight, gives no impulses
// but acts at every tick,
//
//     at each tick dt_r f_0, and at the start of the step dt_q (f_q - f_0):        dt_q f_q in all.
//
// Soil at rest under its weight thus stays there: whole impulses would shake it by dt_q f_q/m.
//
// Particles bring mass and momentum to the grid at the start of their step. A node that particles of several
// clocks share (it moves on the fastest of them) keeps what the slow ones brought until their step ends,
//
//     m_q constant,      p_q <- m_q v+ (APIC)    or    p_q <- p_q + m_q (v+ - v-) (FLIP),
//
// and the slow particles then read of it: the velocity after its last update, the sum of all changes (FLIP),
// and, to move and to strain, the mean of its velocities over their step. A mean over the step of clock q is
// the half sum of the means over the two steps of clock q + 1 in it. Sums p_q, m_q are kept over clocks 0 to
// q, which is what a step that begins with clock q + 1 finds on its nodes.

#include "mpm_domain/state.hpp"
#include "mpm_domain/step/clock_nodes.hpp"
#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"

#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// The passes of one step of clock 0, which is 2^(clocks - 1) ticks of the fastest one. Each tick runs
/// scatter, velocities, (boundary forces), update, gather_velocities, remap and gather_rest, then next().
class Subcycling {
public:
  explicit Subcycling(Domain& domain);

  /// After a sort: which nodes belong to which clock, all fields of the grid being zero.
  void restart();
  /// Of the step that begins, s: its length and the time that forces act for at its first tick, see
  /// Stepper::kick.
  void set_step(double dt, double kick) {
    dt_ = dt;
    kick_ = kick;
  }

  int ticks() const { return 1 << (clocks_ - 1); }
  int tick() const { return tick_; }
  /// The slowest clock that begins a step at this tick, and that ends one with it: with it do all faster
  /// ones.
  int first_due() const { return slowest_at(tick_); }
  int first_ending() const { return slowest_at(tick_ + 1); }
  double dt_of(int clock) const { return dt_ / static_cast<double>(1 << clock); }
  /// Time that forces of a clock act for at this tick: all clocks change their step together.
  double kick_of(int clock) const { return (tick_ == 0 ? kick_ : dt_) / static_cast<double>(1 << clock); }
  /// What a force of a clock that acts at every tick is multiplied with, so that it adds up to kick_of(clock)
  /// in the clock's step.
  double steady_share(int clock) const { return tick_ > 0 && tick_ < ticks() >> clock ? kick_ / dt_ : 1.0; }
  const ClockNodes& nodes() const { return nodes_; }
  /// How often particles are moved in a step, all together.
  double updates_per_step() const;

  void scatter();
  /// v- of all nodes that are due.
  /// @returns their kinetic energy less that after their last update, J/m
  double velocities();
  /// @returns sums of this tick, the kinetic energy that of all nodes
  GridUpdate update();
  void gather_velocities();
  void remap();
  GatherSums gather_rest();
  /// The next tick. False after the last one of the step.
  bool next() {
    tick_ = (tick_ + 1) % ticks();
    return tick_ != 0;
  }

  /// Its part of a checkpoint, see state.hpp; between steps.
  /// @throws std::runtime_error for what was kept for another grid
  template <class Visit>
  void visit_state(Visit& visit) {
    visit("subcycling.kinetic", kinetic_);
    visit_numbers(visit, "subcycling.steady_known", steady_known_);
    nodes_.visit_state(domain_, visit);
    for (int clock = 0; shares(clock); ++clock) {
      visit("subcycling.steady_x" + std::to_string(clock), shared(clock).steady_x);
      visit("subcycling.steady_y" + std::to_string(clock), shared(clock).steady_y);
    }
    require_fit();
    resize_shared();
  }

private:
  /// What nodes that a clock shares with faster ones keep over its step.
  struct Shared {
    NodeField mass, momentum_x, momentum_y; ///< of the particles of this and all slower clocks
    NodeField steady_x, steady_y;           ///< of this one's forces, N/m
    NodeField change_x, change_y;           ///< sum of v+ - v-
    NodeField vx_mean, vy_mean;             ///< of the velocity that strains
    NodeField vx_new_mean, vy_new_mean;     ///< of v+
  };

  int slowest_at(int tick) const;
  void require_fit() const;
  void resize_shared();
  bool shares(int clock) const { return clock + 1 < clocks_; }
  Shared& shared(int clock) { return shared_[static_cast<std::size_t>(clock)]; }
  template <typename Act>
  void over(std::span<const NodeRange> rows, const Act& act);
  void take_held(int first, ScatterPart part);
  void keep(int clock);
  void fold(int clock, ScatterPart part);
  void prolong(int clock);
  void add_steady();
  void add_mean(int clock);
  void take_mean(int clock);
  void mean_acceleration();

  Domain& domain_;
  int clocks_;
  bool affine_;
  double dt_ = 0.0;
  double kick_ = 0.0;
  int tick_ = 0;
  double steady_known_ = 0.0; ///< 1 once the first step after a sort has found the steady forces
  ClockNodes nodes_;
  std::vector<Shared> shared_;
  std::vector<double> kinetic_; ///< of each clock's nodes after their last update, J/m
};

} // namespace tremolo::mpm_domain
