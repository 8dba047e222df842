#pragma once

#include "mpm_domain/boundary/walls/impervious_faces.hpp"
#include "mpm_domain/clocks/clock_nodes.hpp"
#include "mpm_domain/clocks/shared_nodes.hpp"
#include "mpm_domain/clocks/ticks.hpp"
#include "mpm_domain/domain.hpp"
#include "mpm_domain/state.hpp"
#include "mpm_domain/step/time_step.hpp"
#include "mpm_domain/tiles/totals.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// A named, timed part of a step.
struct Pass {
  std::string name;
  std::function<void()> run;
  double seconds = 0.0;
};

/// Advances a domain in time. The step is one list of passes, put together once from the scheme (update
/// stress last, or last with remapped velocity):
///
///   usl:   scatter | velocities | boundary | update | gather all
///   musl:  scatter | velocities | boundary | update | gather velocity | scatter momentum | remap | gather
///   rest
///
/// Soil below the water table adds passes of its own: pore pressures before the particles move, and, where
/// water flows, its own transfers within those of the soil (water/). Structures add contact after the update,
/// and their own motion (contact/). With reduced dispersion internal forces have a pass of their own, and the
/// remapped velocity is sharpened before it strains (transfer/sharp_transfer.hpp).
///
/// It runs on a list of clocks (ticks.hpp): passes after the sort run at every tick for the clocks that begin
/// or end a step of theirs with it. Where all particles take the same step there is one clock and one tick.
///
/// Time levels are those of leapfrog: at time() places and stresses are known; particle velocities belong to
/// velocity_time() = time() - dt/2. Where the step changes, from dt' to dt, the grid update takes velocities
/// from t - dt'/2 to t + dt/2: kick() = (dt' + dt)/2.
class Stepper {
public:
  /// Puts what the spec wants behind the faces of the domain, which is at rest, and makes it ready to step.
  /// @param free_field gives the faces their free field; never called for a domain without faces
  /// @throws std::invalid_argument if the spec's fixed time step is over the critical one, or if the domain
  /// has faces and nobody gives their free field
  Stepper(Domain& domain, double start_time, FreeFieldSource free_field);

  void step();

  double time() const { return time_; }
  double velocity_time() const { return time_ - 0.5 * dt_; }
  double dt() const { return dt_; }     ///< of the step just made, or of the first
  double kick() const { return kick_; } ///< time that the forces of the step just made have acted for, s
  long steps() const { return steps_; }
  /// Motion of a rigid base at velocity_time(); at rest where there is none.
  BaseMotion base_motion() const {
    const auto& base = domain_.boundary.rigid_base();
    return base ? base->motion() : BaseMotion{};
  }
  /// How often this stepper has moved a particle, added up over all particles.
  double particle_updates() const { return updates_; }
  const std::vector<Pass>& passes() const { return passes_; }

  /// Its part of a checkpoint (state.hpp).
  template <class Writer>
  void save(Writer& to) const {
    to.write("stepper", std::vector<double>{time_, dt_, static_cast<double>(steps_), max_speed_, moved_});
    to.write("stepper.kinetic", kinetic_);
    if (ticks_.clocks() > 1) {
      nodes_.save(to);
      shared_.save(to);
    }
  }
  /// Goes on from there; the domain has been restored already.
  template <class Reader>
  void restore(const Reader& from) {
    const std::vector<double> numbers = numbers_of_size(from, "stepper", 5);
    time_ = numbers[0];
    dt_ = numbers[1];
    steps_ = static_cast<long>(numbers[2]);
    max_speed_ = numbers[3];
    moved_ = numbers[4];
    kinetic_ = numbers_of_size(from, "stepper.kinetic", kinetic_.size());
    find_bounds();
    nodes_ = ClockNodes(domain_);
    if (ticks_.clocks() > 1) {
      nodes_.restore(domain_, from);
      shared_.restore(from);
    }
  }

private:
  std::vector<Pass> recipe();
  void run(std::span<Pass> passes);

  void choose_step();
  void sort();
  void scatter_particles();
  void scatter_wet_particles();
  void scatter_motion();
  void scatter_forces();
  void find_velocities();
  void exchange();
  void push_by_base();
  void react();
  void update();
  void update_with_flow();
  void meet_bodies();
  void finish_update();
  void gather_all();
  void gather_velocities();
  void exchange_velocities();
  void scatter_momenta();
  void remap();
  void sharpen();
  void find_pressures();
  void book_lift();
  void gather_rest();
  void move_bodies();
  void gather_accelerations();

  void settle();

  void book_transfer(double time, const ExactSums<1>& power);
  void book(const GatherTotals& sums);
  void follow_fastest();
  void find_bounds();
  double updates_per_step() const;
  double& kinetic_of(int clock) { return kinetic_[static_cast<std::size_t>(clock)]; }

  Domain& domain_;
  FreeFieldSource free_field_;
  double time_;
  double dt_ = 0.0;
  double kick_ = 0.0;
  long steps_ = 0;
  double max_speed_ = 0.0;
  double fastest_moved_ = 0.0; ///< speed of particles of this rank and of structures in the step, m/s
  StepBounds bounds_;          ///< of the next step, of all ranks
  double moved_ = 0.0;         ///< bound on the way of particles and structures since the last sort, m
  double updates_ = 0.0;
  Ticks ticks_;
  ClockNodes nodes_;
  SharedNodes shared_;
  Bookings bookings_;
  ImperviousFaces walls_;
  std::vector<double> kinetic_; ///< K(v+) of each clock's nodes after their last update, J/m
  std::vector<double> kicks_;   ///< time that the forces of that update acted for, s
  std::vector<Pass> passes_;
};

} // namespace tremolo::mpm_domain
