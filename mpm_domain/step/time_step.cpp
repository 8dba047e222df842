#include "mpm_domain/step/time_step.hpp"

#include "mpm_domain/particles/wave_speed.hpp"
#include "mpm_domain/spec/limits.hpp"
#include "mpm_domain/tiles/totals.hpp"

#include <fmt/format.h>

#include <algorithm>
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

/// The least limit of all ranks, of which only that rank knows what sets it.
Limit over_ranks(const Domain& domain, const Limit& limit) {
  const double step = least_of_ranks(domain, limit.step);
  return limit.step == step ? limit : Limit{step};
}

/// The least of steps_of(clock) times the critical step over all particles, where h is the size of the finest
/// cells that a particle touches.
/// @param speed  the waves that count
template <typename StepsOf>
Limit least_step(Domain& domain, double max_speed, const StepsOf& steps_of, double FastestWaves::*speed) {
  const double share = share_of(domain.spec.scheme.order);
  std::vector<Limit> least(domain.block_count());
  domain.workers.run(least.size(), [&](std::size_t block) {
    const double h = domain.lattice(domain.level_of_block(block)).h;
    const double steps = steps_of(domain.clock_of_block(block));
    const auto see = [&](Particles& set, const ParticleRange& range) {
      if (range.begin == range.end)
        return;
      const FastestWaves waves = fastest_waves(set, range);
      const double c = waves.*speed;
      const double undamped = largest_courant_number * h / (c + max_speed);
      const double damping = damping_of_fastest(set, waves.in_skeleton, c);
      least[block] = lesser(least[block], {steps * damped_step(undamped, damping, share), h, c, damping});
    };
    for (Particles& set : domain.sets) {
      see(set, set.in_block(block));
      if (domain.mesh)
        see(set, set.in_block(domain.block_count() + block));
    }
  });
  return over_ranks(domain, *std::ranges::min_element(least, {}, &Limit::step));
}

/// Where all particles take the same step.
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

[[noreturn]] void refuse(const Domain& domain, double dt, Limit limit, double max_speed) {
  for (double Limit::*what : {&Limit::h, &Limit::c, &Limit::damping_time})
    limit.*what = largest_of_ranks(domain, limit.*what);
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

/// The limit of soil in motion if all particles take the same step.
Limit uniform_limit(Domain& domain, double max_speed) {
  return lesser(least_step(domain, max_speed, one_step, &FastestWaves::in_soil), layer_step(domain.spec));
}

/// The limit of clock 0 where every clock keeps to that of its own particles.
Limit subcycled_limit(Domain& domain, double max_speed) {
  const auto steps_of = [](int clock) { return static_cast<double>(1 << clock); };
  return lesser(least_step(domain, max_speed, steps_of, &FastestWaves::in_soil), layer_step(domain.spec));
}

} // namespace

double critical_time_step(Domain& domain, double max_speed) {
  return uniform_limit(domain, max_speed).step;
}

double critical_skeleton_step(Domain& domain) {
  return lesser(least_step(domain, 0.0, one_step, &FastestWaves::in_skeleton), layer_step(domain.spec)).step;
}

double next_time_step(Domain& domain, double max_speed, double last) {
  const Scheme& scheme = domain.spec.scheme;
  const Limit limit = scheme.subcycle ? subcycled_limit(domain, max_speed) : uniform_limit(domain, max_speed);
  // No particle of a mesh with clocks comes near cells of another level before the next sort.
  const double way = scheme.subcycle && max_speed > 0.0 ? 0.5 * domain.sort_distance() / max_speed
                                                        : std::numeric_limits<double>::infinity();
  const double critical = std::min(limit.step, way);
  const double wanted = scheme.dt.value_or(scheme.fraction * critical);
  if (scheme.order == StepOrder::usl && wanted > usl_share * critical)
    throw std::invalid_argument(
        fmt::format("the time step {:.6g} s is not stable with the order usl; allowed: at most {} of "
                    "the critical step, {:.6g} s",
                    wanted, usl_share, usl_share * critical));
  if (scheme.dt) {
    if (*scheme.dt > limit.step)
      refuse(domain, *scheme.dt, limit, max_speed);
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
