#pragma once

#include "mpm_domain/boundary/consistent_dashpots.hpp"
#include "mpm_domain/boundary/subcycled_boundary.hpp"
#include "mpm_domain/domain.hpp"
#include "mpm_domain/state.hpp"
#include "mpm_domain/transfer/gather.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// Gives every face its traction by Eq. (6), static part included, Pa, at a time (s) from the domain's
/// velocities there (m/s). Called once a step.
using TractionSource =
    std::function<void(long step, double time, std::span<const Vector> v_domain, std::span<Vector> traction)>;

/// The free field at every face in the last call of the traction source, for matched layers.
using FreeFieldOfFaces = std::function<std::span<const eq6::FreeField>()>;

/// A named, timed part of a step.
struct Pass {
  std::string name;
  std::function<void()> run;
  double seconds = 0.0;
};

/// Advances a domain in time. The step is a list of passes put together once from the scheme (update stress
/// last, or last with remapped velocity):
///
///   usl:   scatter | velocities | boundary | grid | gather all
///   musl:  scatter | velocities | boundary | grid | gather velocity | scatter motion | remap | gather rest
///
/// Where levels have steps of their own (subcycling.hpp) a step is that of the coarsest one, and all passes
/// after the sort run at each of its ticks.
///
/// Time levels are those of leapfrog: at time() places and stresses are known; particle velocities belong to
/// velocity_time() = time() - dt/2. Where the step changes, from dt' to dt, the grid update takes velocities
/// from t - dt'/2 to t + dt/2: kick() = (dt' + dt)/2.
class Stepper {
public:
  /// @param free_field needed by a domain with matched layers
  /// @throws std::invalid_argument if the spec's fixed time step is over the critical one, or matched layers
  /// are not told the free field
  Stepper(Domain& domain, double start_time, TractionSource source, FreeFieldOfFaces free_field = {});

  void step();

  double time() const { return time_; }
  double velocity_time() const { return time_ - 0.5 * dt_; }
  double dt() const { return dt_; }     ///< of the step just made, or of the first
  double kick() const { return kick_; } ///< time that the forces of the step just made have acted for, s
  long steps() const { return steps_; }
  /// Of all particles, by this stepper: how often one was moved.
  double particle_updates() const { return updates_; }
  const std::vector<Pass>& passes() const { return passes_; }
  /// Of the step just made, per face: v^m before the update (m/s) and the traction (Pa).
  std::span<const Vector> face_velocities() const { return v_face_; }
  std::span<const Vector> face_tractions() const { return traction_; }

  /// Its part of a checkpoint, see state.hpp.
  template <class Visit>
  void visit_state(Visit& visit) {
    visit_numbers(visit, "stepper", time_, dt_, steps_, max_speed_, moved_, kinetic_after_);
    if (subcycling_)
      subcycling_->visit_state(visit);
  }

private:
  void choose_step();
  void choose_dt();
  void sort();
  void velocities();
  void exchange();
  void react();
  void boundary();
  void grid();
  void book_boundary_work();
  void book_remap(double power);
  void book(const GatherSums& sums);
  void book(double kinetic_gain);
  void book(const GridUpdate& update);
  std::vector<Pass> assemble();
  std::vector<Pass> assemble_subcycled();
  void run(std::span<Pass> passes);

  Domain& domain_;
  TractionSource source_;
  FreeFieldOfFaces free_field_;
  double time_;
  double dt_ = 0.0;
  double kick_ = 0.0;
  long steps_ = 0;
  double max_speed_ = 0.0;
  double moved_ = 0.0;         ///< bound on any particle's way since the last sort, m
  double kinetic_after_ = 0.0; ///< K(v+) of the step before
  double updates_ = 0.0;
  std::vector<FaceWeights> weights_;
  std::vector<Vector> v_face_, v_mid_, v_remapped_, traction_;
  std::vector<Vector> reaction_; ///< of matched layers, part of traction_
  ConsistentDashpots dashpots_;
  std::optional<Subcycling> subcycling_;
  std::optional<SubcycledBoundary> subcycled_boundary_;
  std::vector<Pass> passes_;
};

} // namespace tremolo::mpm_domain
