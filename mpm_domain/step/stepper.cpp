#include "mpm_domain/step/stepper.hpp"

#include "mpm_domain/grid/periodic_sides.hpp"
#include "mpm_domain/particles/grid_growth.hpp"
#include "mpm_domain/particles/joining.hpp"
#include "mpm_domain/particles/splitting.hpp"
#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// Of the critical step, with the order usl: in a free body with noise usl grows above (measured;
/// tests/stability/mpm_domain).
constexpr double usl_share = 0.85;

} // namespace

Stepper::Stepper(Domain& domain, double start_time, TractionSource source, FreeFieldOfFaces free_field)
    : domain_(domain), source_(std::move(source)), free_field_(std::move(free_field)), time_(start_time),
      weights_(domain.faces.size()), v_face_(domain.faces.size()), v_mid_(domain.faces.size()),
      v_remapped_(domain.faces.size()), traction_(domain.faces.size()), reaction_(domain.faces.size()) {
  if (!domain.layers.empty() && !free_field_)
    throw std::invalid_argument("matched layers take up what differs from the free field, which is not told");
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      max_speed_ = std::max(max_speed_, std::hypot(set.vx[k], set.vy[k]));
  if (domain.spec.scheme.subcycle) {
    subcycling_.emplace(domain);
    subcycled_boundary_.emplace(domain, *subcycling_);
  }
  if (domain.spec.scheme.transfer == Transfer::fmpm)
    full_mass_.emplace(domain.spec.scheme.fmpm_order);
  passes_ = subcycling_ ? assemble_subcycled() : assemble();
  choose_dt();
}

std::vector<Pass> Stepper::assemble() {
  const auto gather_pass = [this](GatherParts parts, bool of_first) {
    return [this, parts, of_first] { book(gather(domain_, dt_, parts, of_first)); };
  };
  const GatherParts all{.velocity = true, .position = true, .strain = true};
  const GatherParts motion{.velocity = true, .position = true};
  const GatherParts strain{.strain = true};
  std::vector<Pass> passes{{"time step", [this] { choose_step(); }}, {"sort", [this] { sort(); }}};
  const auto add = [&](std::string name, std::function<void()> run) {
    passes.push_back({std::move(name), std::move(run)});
  };
  const auto add_motion = [&](GatherParts parts) {
    const std::function<void()> move = gather_pass(parts, false);
    if (full_mass_)
      add("full mass matrix", [this] { full_mass_->solve(domain_); });
    add("grid to particles", full_mass_ ? [this, move] { move(); full_mass_->restore(domain_); } : move);
  };
  const bool first = domain_.spec.scheme.order == StepOrder::usf;
  const bool drifts = full_mass_ || domain_.spec.scheme.transfer == Transfer::apic;
  add("particles to grid",
      [this, first] { scatter(domain_, first ? ScatterPart::motion : ScatterPart::both); });
  add("grid velocities", [this] { velocities(); });
  if (first) {
    add("strain and stress", gather_pass(strain, true));
    add("forces to grid", [this] { scatter(domain_, ScatterPart::force); });
  }
  add("boundary exchange", [this] { exchange(); });
  if (!domain_.layers.empty())
    add("matched layers", [this] { react(); });
  add("boundary tractions", [this] { boundary(); });
  add("grid update", [this] { grid(); });
  switch (domain_.spec.scheme.order) {
  case StepOrder::usl:
    add("grid to particles, stress", gather_pass(all, false));
    break;
  case StepOrder::usf:
    add_motion(motion);
    break;
  case StepOrder::musl:
    add_motion({.velocity = true});
    add("velocities to grid again", [this] { scatter(domain_, ScatterPart::momentum); });
    add("remapped velocities", [this] { book_remap(remap_velocities(domain_)); });
    add("strain and stress", gather_pass(drifts ? GatherParts{.drift = true, .strain = true}
                                                : GatherParts{.position = true, .strain = true},
                                         true));
    break;
  }
  return passes;
}

std::vector<Pass> Stepper::assemble_subcycled() {
  Subcycling& levels = *subcycling_;
  SubcycledBoundary& faces = *subcycled_boundary_;
  return {{"time step",
           [this, &levels] {
             choose_step();
             levels.set_step(dt_, kick_);
           }},
          {"sort", [this] { sort(); }},
          {"particles to grid", [&levels] { levels.scatter(); }},
          {"grid velocities", [this, &levels] { book(levels.velocities()); }},
          {"boundary exchange",
           [this, &levels, &faces] {
             if (levels.tick() > 0)
               return;
             exchange();
             faces.hold(v_face_, traction_);
           }},
          {"boundary tractions", [&faces] { faces.spread(); }},
          {"grid update",
           [this, &levels, &faces] {
             book(levels.update());
             faces.book();
           }},
          {"grid to particles", [&levels] { levels.gather_velocities(); }},
          {"velocities to grid again", [&levels] { levels.remap(); }},
          {"strain and stress", [this, &levels] { book(levels.gather_rest()); }}};
}

void Stepper::run(std::span<Pass> passes) {
  using Clock = std::chrono::steady_clock;
  Clock::time_point before = Clock::now();
  for (Pass& pass : passes) {
    pass.run();
    const Clock::time_point after = Clock::now();
    pass.seconds += std::chrono::duration<double>(after - before).count();
    before = after;
  }
}

void Stepper::step() {
  constexpr std::size_t once = 2; // time step and sort
  run(std::span(passes_).first(once));
  do
    run(std::span(passes_).subspan(once));
  while (subcycling_ && subcycling_->next());
  moved_ += max_speed_ * dt_;
  updates_ += subcycling_ ? subcycling_->updates_per_step() : static_cast<double>(domain_.particle_count());
  time_ += dt_;
  ++steps_;
}

void Stepper::choose_step() {
  const double before = dt_;
  choose_dt();
  kick_ = 0.5 * (before + dt_);
}

void Stepper::choose_dt() {
  const Scheme& scheme = domain_.spec.scheme;
  const double critical =
      subcycling_ ? critical_subcycled_step(domain_, max_speed_) : critical_time_step(domain_, max_speed_);
  const double wanted = scheme.dt.value_or(scheme.fraction * critical);
  if (scheme.order == StepOrder::usl && wanted > usl_share * critical)
    throw std::invalid_argument(
        fmt::format("the time step {:.6g} s is not stable with the order usl; allowed: at most {} of "
                    "the critical step, {:.6g} s",
                    wanted, usl_share, usl_share * critical));
  if (scheme.dt) {
    if (*scheme.dt > critical && subcycling_)
      throw std::invalid_argument(fmt::format(
          "the time step {:.6g} s of the coarsest level is over the limit {:.6g} s: the least of 2^k 0.65 "
          "h/(c_p + |v|), k the level whose step a particle takes",
          *scheme.dt, critical));
    if (*scheme.dt > critical)
      throw std::invalid_argument(fmt::format(
          "the time step {:.6g} s is over the limit {:.6g} s = 0.65 h/(c_p + |v|) with h = {:.6g} m, c_p = "
          "{:.6g} m/s, |v| = {:.3g} m/s",
          *scheme.dt, critical, domain_.finest_lattice().h, domain_.fastest_wave(), max_speed_));
    dt_ = *scheme.dt;
  } else {
    // Leapfrog is second order only while dt stays the same, so small changes of the limit are let pass.
    if (dt_ == 0.0 || dt_ > std::min(1.02 * wanted, critical) || dt_ < 0.8 * wanted)
      dt_ = wanted;
  }
}

void Stepper::sort() {
  // On a graded mesh a particle must not come near another lattice within the step either.
  const double moves = domain_.mesh ? max_speed_ * dt_ : 0.0;
  if (moved_ + moves < domain_.sort_distance()) {
    weigh_across(domain_);
    return;
  }
  if (domain_.spec.periodic_sides)
    for (Particles& set : domain_.sets)
      wrap(set, domain_.spec.box);
  make_room(domain_, time_, steps_);
  split_particles(domain_);
  if (domain_.spec.join_particles)
    join_particles(domain_);
  sort_particles(domain_);
  if (subcycling_)
    subcycling_->restart();
  moved_ = 0.0;
}

void Stepper::velocities() {
  book(grid_velocities(domain_) - kinetic_after_);
}

/// Kinetic energy of the grid that a transfer from the particles has brought; before the first, all of it.
void Stepper::book(double kinetic_gain) {
  EnergyLedger& energy = domain_.energy;
  if (steps_ == 0 && !(subcycling_ && subcycling_->tick() > 0))
    energy.kinetic_start = kinetic_gain;
  else
    energy.transfer += kinetic_gain;
}

void Stepper::exchange() {
  face_weights(domain_, weights_);
  mpm_domain::face_velocities(domain_, weights_, v_face_);
  source_(steps_, time_, v_face_, traction_);
}

void Stepper::react() {
  std::ranges::fill(reaction_, Vector{});
  mpm_domain::react(domain_, time_, v_face_, free_field_(), reaction_);
  for (std::size_t f = 0; f < traction_.size(); ++f)
    traction_[f] = {traction_[f].x + reaction_[f].x, traction_[f].y + reaction_[f].y};
}

void Stepper::boundary() {
  spread_tractions(domain_, weights_, traction_);
  if (!domain_.layers.empty())
    spread_layer_mass(domain_, weights_, kick_);
  dashpots_.correct(domain_, weights_, kick_);
}

void Stepper::grid() {
  book(update_grid(domain_, kick_));
  book_boundary_work();
}

void Stepper::book(const GridUpdate& update) {
  if (!std::isfinite(update.kinetic))
    throw std::runtime_error(
        fmt::format("a grid velocity is not finite at t = {:.6g} s, step {}", time_, steps_));
  EnergyLedger& energy = domain_.energy;
  energy.kinetic = update.kinetic;
  energy.gravity += update.gravity_work;
  const Grid& grid = domain_.grid;
  const double power = 0.5 * (dashpots_.power(grid.vx, grid.vy) + dashpots_.power(grid.vx_new, grid.vy_new));
  energy.dashpots += update.dashpot_relief + kick_ * power;
  kinetic_after_ = update.kinetic;
}

void Stepper::book_boundary_work() {
  face_mid_velocities(domain_, weights_, v_mid_);
  for (std::size_t f = 0; f < weights_.size(); ++f) {
    const Vector viscous = eq6::viscous_traction(domain_.faces[f].face, v_face_[f]);
    const Vector own = {viscous.x + reaction_[f].x, viscous.y + reaction_[f].y};
    book_face_work(domain_, f, kick_, own, traction_[f], v_mid_[f]);
  }
}

void Stepper::book_remap(double power) {
  // Stresses work on the remapped velocity u of this step and, with trapezoidal work, of the one before,
  // which is v-, while K grows by their power on (v- + v+)/2: half of their power on v+ - u is the
  // transfer's. What weight and boundary do is booked on v+.
  mpm_domain::face_velocities(domain_, weights_, v_remapped_);
  for (std::size_t f = 0; f < weights_.size(); ++f) {
    const Vector lost = {2.0 * v_mid_[f].x - v_face_[f].x - v_remapped_[f].x,
                         2.0 * v_mid_[f].y - v_face_[f].y - v_remapped_[f].y};
    power -= domain_.faces[f].length * (traction_[f].x * lost.x + traction_[f].y * lost.y);
  }
  const Grid& grid = domain_.grid;
  power -= dashpots_.power(grid.vx_new, grid.vy_new) - dashpots_.power(grid.vx, grid.vy);
  domain_.energy.transfer += 0.5 * kick_ * power;
}

void Stepper::book(const GatherSums& sums) {
  domain_.energy.elastic += sums.elastic;
  domain_.energy.plastic += sums.plastic;
  if (sums.max_speed > 0.0)
    max_speed_ = sums.max_speed;
}

} // namespace tremolo::mpm_domain
