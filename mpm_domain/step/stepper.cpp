#include "mpm_domain/step/stepper.hpp"

#include "mpm_domain/dispersion/fullness.hpp"
#include "mpm_domain/grid/periodic_sides.hpp"
#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/particles/grid_growth.hpp"
#include "mpm_domain/particles/splitting.hpp"
#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/step/time_step.hpp"
#include "mpm_domain/tiles/totals.hpp"
#include "mpm_domain/transfer/out_of_reach.hpp"
#include "mpm_domain/transfer/sharp_transfer.hpp"
#include "mpm_domain/water/mixture_update.hpp"
#include "mpm_domain/water/pore_pressure.hpp"
#include "mpm_domain/water/water_gather.hpp"
#include "mpm_domain/water/water_scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// Particles, and points of structures: both must not go far from one sort to the next.
double fastest_point(const Domain& domain) {
  double speed = domain.contact.fastest_point();
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      speed = std::max(speed, std::hypot(set.vx[k], set.vy[k]));
  take_largest(domain, {&speed, 1});
  return speed;
}

Communicator* ranks_of(const Domain& domain) {
  return domain.share ? domain.share->ranks : nullptr;
}

} // namespace

Stepper::Stepper(Domain& domain, double start_time, FreeFieldSource free_field)
    : domain_(domain), free_field_(std::move(free_field)), time_(start_time),
      max_speed_(fastest_point(domain)), ticks_(domain.clocks.count()), nodes_(domain),
      shared_(domain, ticks_, nodes_), bookings_(ranks_of(domain)),
      kinetic_(static_cast<std::size_t>(ticks_.clocks())), kicks_(kinetic_.size()) {
  if (!free_field_ && !domain.boundary.faces().empty())
    throw std::invalid_argument("a domain with boundary faces needs to be told their free field");
  domain.boundary.build_supports(domain);
  passes_ = recipe();
  find_bounds();
  dt_ = next_time_step(domain_, bounds_, max_speed_, 0.0);
}

std::vector<Pass> Stepper::recipe() {
  std::vector<Pass> passes;
  const auto add = [&](std::string name, void (Stepper::*pass)()) {
    passes.push_back({std::move(name), [this, pass] { (this->*pass)(); }});
  };
  add("time step", &Stepper::choose_step);
  add("sort", &Stepper::sort);
  if (domain_.is_sharp()) {
    add("particles to grid", &Stepper::scatter_motion);
    add("sharpened forces", &Stepper::scatter_forces);
  } else {
    add("particles to grid",
        domain_.has_water() ? &Stepper::scatter_wet_particles : &Stepper::scatter_particles);
  }
  add("grid velocities", &Stepper::find_velocities);
  add("boundary exchange", &Stepper::exchange);
  if (domain_.boundary.has_layers())
    add("matched layers", &Stepper::react);
  if (domain_.boundary.rigid_base())
    add("inertia", &Stepper::push_by_base);
  else
    passes.push_back({"boundary tractions", [this] { domain_.boundary.apply(domain_, ticks_, nodes_); }});
  add("grid update", domain_.has_flow() ? &Stepper::update_with_flow : &Stepper::update);
  if (domain_.contact.any())
    add("contact", &Stepper::meet_bodies);
  if (domain_.spec.scheme.order == StepOrder::usl) {
    if (domain_.has_pore_pressure())
      add("pore pressure", &Stepper::find_pressures);
    if (domain_.has_water())
      add("weight under water", &Stepper::book_lift);
    add("grid to particles, stress", &Stepper::gather_all);
  } else {
    if (domain_.has_flow()) {
      add("grid to particles and back", &Stepper::exchange_velocities);
    } else {
      add("grid to particles", &Stepper::gather_velocities);
      add("velocities to grid again", &Stepper::scatter_momenta);
    }
    add("remapped velocities", &Stepper::remap);
    if (domain_.is_sharp())
      add("sharpened velocities", &Stepper::sharpen);
    if (domain_.has_pore_pressure())
      add("pore pressure", &Stepper::find_pressures);
    if (domain_.has_water())
      add("weight under water", &Stepper::book_lift);
    add("strain and stress", &Stepper::gather_rest);
  }
  if (domain_.contact.any())
    add("bodies", &Stepper::move_bodies);
  add("accelerations", &Stepper::gather_accelerations);
  if (domain_.share)
    add("totals over ranks", &Stepper::settle);
  return passes;
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
  try {
    run(std::span(passes_).first(once));
    do
      run(std::span(passes_).subspan(once));
    while (ticks_.next());
  } catch (const OutOfReach& error) {
    throw std::runtime_error(fmt::format("{} (t = {:.6g} s, step {})", error.what(), time_, steps_));
  }
  moved_ += max_speed_ * dt_;
  updates_ += updates_per_step();
  time_ += dt_;
  ++steps_;
}

void Stepper::choose_step() {
  const double before = dt_;
  if (!domain_.share)
    bounds_ = step_bounds(domain_);
  dt_ = next_time_step(domain_, bounds_, max_speed_, before);
  kick_ = 0.5 * (before + dt_);
  ticks_.set_step(dt_, kick_);
}

void Stepper::sort() {
  // On a graded mesh a particle must not come near another lattice within the step either.
  const double moves = domain_.mesh ? max_speed_ * dt_ : 0.0;
  if (moved_ + moves < domain_.sort_distance()) {
    weigh_across(domain_);
    return;
  }
  if (domain_.spec.periodic())
    for (Particles& set : domain_.sets_of_soil())
      wrap(set, domain_.spec.box);
  make_room(domain_, time_, steps_);
  split_particles(domain_);
  sort_particles(domain_);
  nodes_ = ClockNodes(domain_);
  shared_.restart();
  moved_ = 0.0;
}

void Stepper::scatter_particles() {
  const int first = ticks_.first_due();
  if (!ticks_.is_first())
    weigh_across(domain_, first);
  clear(domain_, ScatterPart::both, nodes_.from(first));
  shared_.take_masses(first);
  for (int clock = first; clock < ticks_.clocks(); ++clock) {
    add_particles(domain_, ScatterPart::both, clock);
    fold(domain_, ScatterPart::both, nodes_.ties_of(clock));
    shared_.keep(clock);
  }
  shared_.add_steady();
  domain_.boundary.read_soil(domain_);
  if (const auto& base = domain_.boundary.rigid_base())
    base->stop(domain_.grid);
}

void Stepper::scatter_wet_particles() {
  scatter_mixture(domain_, nodes_.of(0), nodes_.ties_of(0));
  domain_.boundary.read_soil(domain_);
}

void Stepper::scatter_motion() {
  scatter(domain_, ScatterPart::motion);
  domain_.boundary.read_soil(domain_);
}

void Stepper::scatter_forces() {
  find_fullness(domain_);
  scatter_sharp_forces(domain_);
}

void Stepper::find_velocities() {
  // Kinetic energy of the grid that a transfer from the particles has brought; before the first, all of it.
  EnergyLedger& energy = domain_.energy;
  const bool starts = steps_ == 0 && ticks_.is_first();
  if (starts)
    energy.kinetic_start = 0.0;
  double& gained = starts ? energy.kinetic_start : energy.transfer;
  for (int clock = ticks_.first_due(); clock < ticks_.clocks(); ++clock)
    bookings_.add(grid_velocities(domain_, nodes_.of(clock)),
                  [this, &gained, clock](const auto& kinetic) { gained += kinetic[0] - kinetic_of(clock); });
  if (domain_.has_flow())
    bookings_.add(water_velocities(domain_, nodes_.of(0)),
                  [&gained](const auto& kinetic) { gained += kinetic[0]; });
}

void Stepper::exchange() {
  if (ticks_.is_first() && !domain_.boundary.faces().empty())
    domain_.boundary.exchange(domain_, nodes_, free_field_, steps_, time_);
}

void Stepper::push_by_base() {
  RigidBase& base = *domain_.boundary.rigid_base();
  if (ticks_.is_first())
    base.move(domain_.boundary.free_field().front().velocity, dt_, ticks_.clocks());
  for (int clock = ticks_.first_due(); clock < ticks_.clocks(); ++clock)
    base.push(domain_, ticks_, clock, nodes_.of(clock));
}

void Stepper::react() {
  if (ticks_.is_first())
    domain_.boundary.react(time_, domain_.workers);
}

void Stepper::update() {
  for (int clock = ticks_.first_due(); clock < ticks_.clocks(); ++clock) {
    const double kick = ticks_.kick_of(clock);
    kicks_[static_cast<std::size_t>(clock)] = kick;
    bookings_.add(update_grid(domain_, kick, nodes_.of(clock)), [this, clock](const auto& totals) {
      const GridUpdate update(totals);
      kinetic_of(clock) = update.kinetic;
      domain_.energy.gravity += update.gravity_work;
      domain_.energy.dashpots += update.dashpot_relief;
    });
  }
  if (!domain_.contact.any())
    finish_update();
}

void Stepper::update_with_flow() {
  walls_.close(domain_, domain_.boundary);
  kicks_.front() = ticks_.kick_of(0);
  bookings_.add(update_mixture(domain_, kicks_.front(), nodes_.of(0)), [this](const auto& totals) {
    const MixtureUpdate update(totals);
    EnergyLedger& energy = domain_.energy;
    kinetic_.front() = update.kinetic;
    energy.gravity += update.gravity_work;
    energy.dashpots += update.dashpot_relief;
    energy.drag += update.drag;
  });
  if (!domain_.contact.any())
    finish_update();
}

void Stepper::meet_bodies() {
  EnergyLedger& energy = domain_.energy;
  const ContactWork work = domain_.contact.meet(domain_, kicks_.front());
  kinetic_.front() += work.kinetic;
  energy.gravity += work.gravity;
  energy.drag += work.drag;
  energy.friction += work.friction;
  energy.impact += work.impact;
  finish_update();
}

void Stepper::finish_update() {
  const BoundaryWork work = domain_.boundary.follow_update(domain_, ticks_, nodes_);
  bookings_.add([this, work] {
    EnergyLedger& energy = domain_.energy;
    energy.kinetic =
        std::accumulate(kinetic_.begin(), kinetic_.end(), 0.0) + domain_.contact.kinetic_energy();
    if (!std::isfinite(energy.kinetic))
      throw std::runtime_error(
          fmt::format("a grid velocity is not finite at t = {:.6g} s, step {}", time_, steps_));
    energy.static_ += work.held;
    energy.dashpots += work.dashpots;
    energy.springs += work.springs;
    energy.transfer += work.transfer;
    energy.input += work.input;
  });
  if (const auto& base = domain_.boundary.rigid_base())
    for (int clock = ticks_.first_due(); clock < ticks_.clocks(); ++clock)
      bookings_.add(base->power(domain_, clock, nodes_.of(clock)),
                    [this, kick = ticks_.kick_of(clock)](const auto& power) {
                      domain_.energy.input += kick * power[0];
                    });
  if (domain_.has_flow())
    bookings_.add([this, work_of_walls = kicks_.front() * walls_.open(domain_)] {
      domain_.energy.drag -= work_of_walls;
    });
  shared_.follow_update();
}

void Stepper::gather_all() {
  prolong(domain_, NodeGroup::velocity, nodes_.ties_of(0));
  if (domain_.has_flow()) {
    prolong(domain_, NodeGroup::water_velocity, nodes_.ties_of(0));
    gather_water(domain_);
  }
  book(gather(domain_, dt_, {.velocity = true, .position = true, .strain = true}, 0));
}

/// Fast clocks come first: then each slower clock may replace the velocities of nodes that it shares with
/// faster ones by those that its own particles read.
void Stepper::gather_velocities() {
  for (int clock = ticks_.clocks() - 1; clock >= ticks_.first_ending(); --clock) {
    prolong(domain_, NodeGroup::velocity, nodes_.ties_of(clock));
    gather(domain_, ticks_.dt_of(clock), {.velocity = true, .sharp = domain_.is_sharp()}, clock);
  }
}

/// Both passes for grains and water that flows.
void Stepper::exchange_velocities() {
  prolong(domain_, NodeGroup::velocity, nodes_.ties_of(0));
  prolong(domain_, NodeGroup::water_velocity, nodes_.ties_of(0));
  exchange_mixture_velocities(domain_, nodes_.of(0), nodes_.ties_of(0));
}

void Stepper::scatter_momenta() {
  const int first = ticks_.first_ending();
  clear(domain_, ScatterPart::momentum, nodes_.from(first));
  shared_.take_momenta(first);
  for (int clock = first; clock < ticks_.clocks(); ++clock) {
    add_particles(domain_, ScatterPart::momentum, clock);
    fold(domain_, ScatterPart::momentum, nodes_.ties_of(clock));
  }
  if (const auto& base = domain_.boundary.rigid_base())
    base->stop(domain_.grid);
}

// With the trapezoidal rule, the work of the stresses is booked on the mean of this step's remapped velocity
// u and the last one, which is v-. The kinetic energy grows by their power on (v- + v+)/2. Half of their
// power on v+ - u is therefore booked as transfer. The work of weight and boundary is booked on v+. What
// contact takes off u strains no soil, but the next step begins with it, v- being what the particles have:
// the other half of the power on it belongs to that step, and is booked here with the stresses of this one.
void Stepper::remap() {
  for (int clock = ticks_.first_ending(); clock < ticks_.clocks(); ++clock) {
    ExactSums<1> power = remap_velocities(domain_, nodes_.of(clock));
    domain_.boundary.take_off_remap_power(domain_, nodes_, clock, power[0]);
    if (const auto& base = domain_.boundary.rigid_base())
      power[0] += base->remap_power(domain_, clock, nodes_.of(clock))[0];
    book_transfer(0.5 * kicks_[static_cast<std::size_t>(clock)], power);
  }
  if (domain_.has_flow())
    book_transfer(0.5 * kicks_.front(), remap_flux(domain_, nodes_.of(0)));
  if (domain_.contact.any())
    domain_.energy.transfer += kicks_.front() * domain_.contact.meet_remapped(domain_);
}

/// Books a time (s) times a power (W/m).
void Stepper::book_transfer(double time, const ExactSums<1>& power) {
  bookings_.add(power, [this, time](const auto& total) { domain_.energy.transfer += time * total[0]; });
}

void Stepper::sharpen() {
  sharpen_strain(domain_);
}

/// The update and the remap have booked all of the weight.
void Stepper::book_lift() {
  bookings_.add(lift_power(domain_, nodes_.of(0)), [this, kick = kicks_.front()](const auto& power) {
    domain_.energy.gravity += kick * power[0];
  });
  if (domain_.spec.scheme.order == StepOrder::musl)
    book_transfer(-0.5 * kicks_.front(), lift_remap_power(domain_, nodes_.of(0)));
}

/// The pressures of a step follow from the velocities that strain the soil, and from the flux of both where
/// water flows.
void Stepper::find_pressures() {
  const Grid& grid = domain_.grid;
  const bool remapped = domain_.spec.scheme.order == StepOrder::musl;
  const auto update = [&](const NodeField& flux_x, const NodeField& flux_y) {
    bookings_.add(update_pressures(domain_, ticks_.dt_of(0), flux_x, flux_y, nodes_.of(0), nodes_.ties_of(0)),
                  [this](const auto& work) { domain_.energy.pore += work[0]; });
  };
  if (domain_.has_flow()) {
    if (!remapped)
      find_flux(domain_, nodes_.of(0));
    prolong(domain_, NodeGroup::volume_flux, nodes_.ties_of(0));
    return update(grid.flux_x, grid.flux_y);
  }
  prolong(domain_, NodeGroup::velocity, nodes_.ties_of(0));
  remapped ? update(grid.vx_strain, grid.vy_strain) : update(grid.vx_after, grid.vy_after);
}

void Stepper::gather_rest() {
  const bool drifts = ticks_.clocks() == 1 && domain_.spec.scheme.transfer == Transfer::apic;
  const bool sharp = domain_.is_sharp();
  const GatherParts rest = drifts
                               ? GatherParts{.drift = true, .strain = true, .remapped = true, .sharp = sharp}
                               : GatherParts{.position = true, .strain = true, .remapped = true};
  GatherTotals sums;
  for (int clock = ticks_.clocks() - 1; clock >= ticks_.first_ending(); --clock) {
    shared_.take_mean(clock);
    prolong(domain_, NodeGroup::velocity, nodes_.ties_of(clock));
    sums += gather(domain_, ticks_.dt_of(clock), rest, clock);
    shared_.add_mean(clock);
  }
  book(sums);
}

void Stepper::move_bodies() {
  moved_ += domain_.contact.move(domain_, dt_);
}

/// Accelerations are for output alone.
void Stepper::gather_accelerations() {
  if (ticks_.first_ending() > 0)
    return;
  shared_.mean_accelerations();
  prolong(domain_, NodeGroup::acceleration, domain_.soil_ties);
}

void Stepper::book(const GatherTotals& sums) {
  bookings_.add(sums.works, [this](const auto& works) {
    domain_.energy.elastic += works[0];
    domain_.energy.plastic += works[1];
    domain_.energy.viscous += works[2];
  });
  fastest_moved_ = std::max(sums.max_speed, domain_.contact.fastest_point());
  if (!domain_.share)
    follow_fastest();
}

void Stepper::follow_fastest() {
  if (fastest_moved_ > 0.0)
    max_speed_ = fastest_moved_;
}

void Stepper::find_bounds() {
  bounds_ = step_bounds(domain_);
  take_largest(domain_, bounds_);
}

/// One message has what this step books and what bounds the next one.
void Stepper::settle() {
  bounds_ = step_bounds(domain_);
  bounds_.push_back(fastest_moved_);
  bookings_.settle(bounds_);
  fastest_moved_ = bounds_.back();
  bounds_.pop_back();
  follow_fastest();
}

double Stepper::updates_per_step() const {
  double updates = 0.0;
  if (domain_.share) {
    for (const std::int64_t particles : domain_.share->deal.particles)
      updates += static_cast<double>(particles);
    return updates;
  }
  const std::size_t tiles = domain_.tiles.count();
  for (const Particles& set : domain_.sets)
    for (int clock = 0; clock < ticks_.clocks(); ++clock) {
      const auto count = [&](std::size_t first_block) {
        return static_cast<double>(set.block_start[first_block + tiles] - set.block_start[first_block]);
      };
      const double across = domain_.mesh ? count(domain_.across_block(clock, 0)) : 0.0;
      updates += (count(domain_.block(clock, 0)) + across) * static_cast<double>(1 << clock);
    }
  return updates;
}

} // namespace tremolo::mpm_domain
