#include "mpm_domain/step/time_step.hpp"

#include "mpm_domain/particles/wave_speed.hpp"
#include "mpm_domain/spec/limits.hpp"
#include "mpm_domain/tiles/totals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// beta of the fastest motion, s: viscous damping acts on the stiffness of the skeleton, of which water adds
/// its own.
double damping_of_fastest(const Particles& set, double in_skeleton, double speed) {
  if (!set.traits.wet || set.damping_time == 0.0)
    return set.damping_time;
  const double share = in_skeleton / speed;
  return set.damping_time * share * share;
}

/// A limit of the step, s, and what sets it: cells of size h (m), waves of speed c (m/s), and the damping
/// time of the soil, s.
struct Limit {
  double step = std::numeric_limits<double>::infinity();
  double h = 0.0;
  double c = 0.0;
  double damping_time = 0.0;
};

Limit lesser(const Limit& one, const Limit& other) {
  return other.step < one.step ? other : one;
}

/// The least of steps_of(clock) times the critical step over all particles, where h is the size of the finest
/// cells that a particle touches. Limits fall with c and with the damping time, so the largest will do.
template <typename StepsOf>
Limit least_step(const Domain& domain, const StepBounds& bounds, double max_speed, const StepsOf& steps_of) {
  const double share = share_of(domain.spec.scheme.order);
  Limit least;
  std::size_t entry = 0;
  for (std::size_t set = 0; set < domain.sets.size(); ++set)
    for (int level = 0; level < domain.lattice_count(); ++level)
      for (int clock = 0; clock < domain.clocks.count(); ++clock, ++entry) {
        const double c = bounds[2 * entry];
        const double damping = bounds[2 * entry + 1];
        if (c < 0.0)
          continue;
        const double h = domain.lattice(level).h;
        const double undamped = largest_courant_number * h / (c + max_speed);
        const double steps = steps_of(clock);
        least = lesser(least, {steps * damped_step(undamped, damping, share), h, c, damping});
      }
  return least;
}

/// Factor on the step of a clock if all particles take the same step.
double one_step(int /*clock*/) {
  return 1.0;
}

/// The limit 0.65 h/c_p of a matched layer at the base whose ground is not the soil; infinity if there is
/// none.
Limit layer_step(const Spec& spec) {
  const bool has_layer = std::ranges::find(spec.matched_sides, Side::base) != spec.matched_sides.end();
  if (!spec.below_base || !has_layer)
    return {};
  const double c = spec.below_base->p_wave_speed();
  return {largest_courant_number * spec.cell_size / c, spec.cell_size, c};
}

[[noreturn]] void refuse(const Domain& domain, double dt, const Limit& limit, double max_speed) {
  const bool has_clocks = domain.clocks.count() > 1;
  const char* undamped = "0.65 h/(c_p + |v|)";
  std::string formula =
      limit.damping_time > 0.0
          ? fmt::format("sqrt(t^2 + beta^2) - beta, t = {}, beta = {:.3g} s", undamped, limit.damping_time)
          : undamped;
  if (has_clocks)
    formula = "2^k times " + formula + ", k the level whose step a particle takes";
  throw std::invalid_argument(fmt::format(
      "the time step {:.6g} s{} is over the limit {:.6g} s = {}, with h = {:.6g} m, c_p = {:.6g} "
      "m/s, |v| = {:.3g} m/s",
      dt, has_clocks ? " of the coarsest level" : "", limit.step, formula, limit.h, limit.c, max_speed));
}

/// The limit if all particles take the same step.
Limit uniform_limit(const Domain& domain, const StepBounds& bounds, double max_speed) {
  return lesser(least_step(domain, bounds, max_speed, one_step), layer_step(domain.spec));
}

/// The limit of clock 0 where every clock keeps to that of its own particles.
Limit subcycled_limit(const Domain& domain, const StepBounds& bounds, double max_speed) {
  const auto steps_of = [](int clock) { return static_cast<double>(1 << clock); };
  return lesser(least_step(domain, bounds, max_speed, steps_of), layer_step(domain.spec));
}

constexpr double no_particles = -1.0;

StepBounds bounds_of(Domain& domain, double FastestWaves::*speed) {
  const std::size_t numbers = 2 * domain.sets.size(); // of a block
  std::vector<double> of_blocks(domain.block_count() * numbers, no_particles);
  domain.workers.run(domain.block_count(), [&](std::size_t block) {
    double* next = &of_blocks[block * numbers];
    for (Particles& set : domain.sets) {
      const auto see = [&](const ParticleRange& range) {
        if (range.begin == range.end)
          return;
        const FastestWaves waves = fastest_waves(set, range);
        const double c = waves.*speed;
        next[0] = std::max(next[0], c);
        next[1] = std::max(next[1], damping_of_fastest(set, waves.in_skeleton, c));
      };
      see(set.in_block(block));
      if (domain.mesh)
        see(set.in_block(domain.block_count() + block));
      next += 2;
    }
  });
  const auto lattices = static_cast<std::size_t>(domain.lattice_count());
  const auto clocks = static_cast<std::size_t>(domain.clocks.count());
  StepBounds bounds(numbers * lattices * clocks, no_particles);
  const double* next = of_blocks.data();
  for (std::size_t block = 0; block < domain.block_count(); ++block) {
    const auto level = static_cast<std::size_t>(domain.level_of_block(block));
    const auto clock = static_cast<std::size_t>(domain.clock_of_block(block));
    for (std::size_t s = 0; s < domain.sets.size(); ++s, next += 2) {
      double* const bound = &bounds[2 * ((s * lattices + level) * clocks + clock)];
      bound[0] = std::max(bound[0], next[0]);
      bound[1] = std::max(bound[1], next[1]);
    }
  }
  return bounds;
}

} // namespace

StepBounds step_bounds(Domain& domain) {
  return bounds_of(domain, &FastestWaves::in_soil);
}

double critical_time_step(Domain& domain, double max_speed) {
  StepBounds bounds = step_bounds(domain);
  take_largest(domain, bounds);
  return std::min(uniform_limit(domain, bounds, max_speed).step, domain.props.critical_step());
}

double fastest_point(const Domain& domain) {
  double speed = std::max(domain.contact.fastest_point(), domain.linings.fastest_point());
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      speed = std::max(speed, std::hypot(set.vx[k], set.vy[k]));
  take_largest(domain, {&speed, 1});
  return speed;
}

double critical_skeleton_step(Domain& domain) {
  StepBounds bounds = bounds_of(domain, &FastestWaves::in_skeleton);
  take_largest(domain, bounds);
  return std::min(uniform_limit(domain, bounds, 0.0).step, domain.props.critical_step());
}

double next_time_step(const Domain& domain, const StepBounds& bounds, double max_speed, double last) {
  const Scheme& scheme = domain.spec.scheme;
  const Limit limit =
      scheme.subcycle ? subcycled_limit(domain, bounds, max_speed) : uniform_limit(domain, bounds, max_speed);
  // No particle of a mesh with clocks comes near cells of another level before the next sort.
  const double way = scheme.subcycle && max_speed > 0.0 ? 0.5 * domain.sort_distance() / max_speed
                                                        : std::numeric_limits<double>::infinity();
  const double of_props = domain.props.critical_step();
  const double critical = std::min({limit.step, way, of_props});
  const double wanted = scheme.dt.value_or(scheme.fraction * critical);
  if (scheme.order == StepOrder::usl && wanted > usl_share * critical)
    throw std::invalid_argument(
        fmt::format("the time step {:.6g} s is not stable with the order usl; allowed: at most {} of "
                    "the critical step, {:.6g} s",
                    wanted, usl_share, usl_share * critical));
  if (scheme.dt) {
    if (*scheme.dt > limit.step)
      refuse(domain, *scheme.dt, limit, max_speed);
    if (*scheme.dt > of_props)
      throw std::invalid_argument(fmt::format(
          "the time step {:.6g} s is over {:.6g} s, which the stiffest prop with what it holds allows",
          *scheme.dt, of_props));
    if (*scheme.dt > way)
      throw std::invalid_argument(fmt::format("the time step {:.6g} s of the coarsest level is over {:.6g} "
                                              "s, in which the fastest particle, {:.3g} "
                                              "m/s, comes near cells of another level",
                                              *scheme.dt, way, max_speed));
    return *scheme.dt;
  }
  const bool changes = last == 0.0 || last > std::min(1.02 * wanted, critical) || last < 0.8 * wanted;
  return changes ? wanted : last;
}

} // namespace tremolo::mpm_domain
