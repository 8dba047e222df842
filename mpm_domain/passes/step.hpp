#pragma once

// The state of a step, which all passes share: its length and ticks, which nodes move on which clock, and
// what has been booked of it. Forces act on a node of clock r from half a step of that clock before a tick to
// half a step after it; where the step changes, from dt' to dt, the first kick lasts (dt' + dt)/2.

#include "mpm_domain/clocks/clock_nodes.hpp"
#include "mpm_domain/clocks/shared_nodes.hpp"
#include "mpm_domain/clocks/ticks.hpp"
#include "mpm_domain/passes/energy_ledger.hpp"
#include "mpm_domain/tiles/totals.hpp"

#include <vector>

namespace tremolo::mpm_domain {

struct Step {
  /// @param at_rest,ledger  outlive this
  Step(Ground& at_rest, EnergyLedger& ledger, double start_time);
  ~Step();
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

  Ground& ground;
  double time;       ///< at which places and stresses are known, s
  double dt = 0.0;   ///< of clock 0, s
  double kick = 0.0; ///< time that forces act for at the first tick, s
  long count = 0;    ///< of the steps made before

  Ticks ticks;
  ClockNodes nodes;
  SharedNodes shared;

  EnergyLedger& energy;
  Bookings bookings;
  std::vector<double> kicks;     ///< by clock: time that the forces of its last update acted for, s
  std::vector<double> kinetic;   ///< by clock: K(v+) of its nodes after that update, J/m
  double kinetic_off_grid = 0.0; ///< of what moves without nodes, J/m
  /// Power of the nodal forces without weight on the difference between v+ and u, by clock, W/m.
  std::vector<ExactSums<1>> remap_power;

  double max_speed = 0.0;     ///< of the last step, all ranks, m/s
  double fastest = 0.0;       ///< speed of the fastest point that this step has moved, m/s
  double pushed = 0.0;        ///< longest way of a particle that this step has pushed out of a structure, m
  double moved = 0.0;         ///< bound on the way of all points since the last sort, m
  std::vector<double> bounds; ///< of the length of the next step, all ranks (step/time_step.hpp)

  /// Whether particles come to the grid for the first time.
  bool starts() const { return count == 0 && ticks.is_first(); }
  /// The entry for kinetic energy that a transfer brings to the grid: before the first, all of it.
  double& gained() { return starts() ? energy.kinetic_start : energy.transfer; }
  /// Books a duration (s) times a power (W/m) as transfer.
  void book_transfer(double duration, const ExactSums<1>& power);

  /// Its part of a checkpoint (state.hpp).
  template <class Writer>
  void save(Writer& to) const {
    to.write("stepper", std::vector<double>{time, dt, static_cast<double>(count), max_speed, moved});
    to.write("stepper.kinetic", kinetic);
    if (ticks.clocks() > 1) {
      nodes.save(to);
      shared.save(to);
    }
  }
  /// Goes on from there; the ground has been restored already.
  template <class Reader>
  void restore(const Reader& from) {
    const std::vector<double> numbers = numbers_of_size(from, "stepper", 5);
    time = numbers[0];
    dt = numbers[1];
    count = static_cast<long>(numbers[2]);
    max_speed = numbers[3];
    moved = numbers[4];
    kinetic = numbers_of_size(from, "stepper.kinetic", kinetic.size());
    nodes = ClockNodes(ground);
    if (ticks.clocks() > 1) {
      nodes.restore(ground, from);
      shared.restore(from);
    }
  }
};

} // namespace tremolo::mpm_domain
