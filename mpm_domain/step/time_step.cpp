#include "mpm_domain/step/time_step.hpp"

#include "mpm_domain/particles/wave_speed.hpp"
#include "mpm_domain/spec/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
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

/// The least of steps_of(clock) times the critical step over all particles, where h is the size of the finest
/// cells that a particle touches.
/// @param speed  the waves that count
template <typename StepsOf>
double least_step(Domain& domain, double max_speed, const StepsOf& steps_of, double FastestWaves::*speed) {
  const double share = share_of(domain.spec.scheme.order);
  std::vector<double> least(domain.block_count(), std::numeric_limits<double>::infinity());
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
      least[block] = std::min(least[block], steps * damped_step(undamped, damping, share));
    };
    for (Particles& set : domain.sets) {
      see(set, set.in_block(block));
      if (domain.mesh)
        see(set, set.in_block(domain.block_count() + block));
    }
  });
  return *std::ranges::min_element(least);
}

/// Where all particles take the same step.
double one_step(int /*clock*/) {
  return 1.0;
}

/// The limit 0.65 h/c_p of a matched layer at the base whose ground is not the soil; infinity if there is
/// none.
double layer_step(const Spec& spec) {
  const bool has_layer = std::ranges::find(spec.matched_sides, Side::base) != spec.matched_sides.end();
  if (!spec.below_base || !has_layer)
    return std::numeric_limits<double>::infinity();
  return largest_courant_number * spec.cell_size / spec.below_base->p_wave_speed();
}

[[noreturn]] void refuse(Domain& domain, double dt, double critical, double max_speed) {
  if (std::ranges::any_of(domain.sets, [](const Particles& set) { return set.damping_time > 0.0; }))
    throw std::invalid_argument(fmt::format(
        "the time step {:.6g} s is over the limit {:.6g} s: the least of sqrt(t^2 + beta^2) - beta, t "
        "= 0.65 h/(c_p + |v|) and beta the damping time of the soil",
        dt, critical));
  if (domain.clocks.count() > 1)
    throw std::invalid_argument(fmt::format(
        "the time step {:.6g} s of the coarsest level is over the limit {:.6g} s: the least of 2^k 0.65 "
        "h/(c_p + |v|), k the level whose step a particle takes",
        dt, critical));
  throw std::invalid_argument(fmt::format(
      "the time step {:.6g} s is over the limit {:.6g} s = 0.65 h/(c_p + |v|) with h = {:.6g} m, c_p = "
      "{:.6g} m/s, |v| = {:.3g} m/s",
      dt, critical, domain.finest_lattice().h, domain.fastest_wave(), max_speed));
}

} // namespace

double critical_time_step(Domain& domain, double max_speed) {
  return std::min(least_step(domain, max_speed, one_step, &FastestWaves::in_soil), layer_step(domain.spec));
}

double critical_skeleton_step(Domain& domain) {
  return std::min(least_step(domain, 0.0, one_step, &FastestWaves::in_skeleton), layer_step(domain.spec));
}

double critical_subcycled_step(Domain& domain, double max_speed) {
  const double stable =
      std::min(least_step(
                   domain, max_speed, [](int clock) { return static_cast<double>(1 << clock); },
                   &FastestWaves::in_soil),
               layer_step(domain.spec));
  return max_speed > 0.0 ? std::min(stable, 0.5 * domain.sort_distance() / max_speed) : stable;
}

double next_time_step(Domain& domain, double max_speed, double last) {
  const Scheme& scheme = domain.spec.scheme;
  const double critical =
      scheme.subcycle ? critical_subcycled_step(domain, max_speed) : critical_time_step(domain, max_speed);
  const double wanted = scheme.dt.value_or(scheme.fraction * critical);
  if (scheme.order == StepOrder::usl && wanted > usl_share * critical)
    throw std::invalid_argument(
        fmt::format("the time step {:.6g} s is not stable with the order usl; allowed: at most {} of "
                    "the critical step, {:.6g} s",
                    wanted, usl_share, usl_share * critical));
  if (scheme.dt) {
    if (*scheme.dt > critical)
      refuse(domain, *scheme.dt, critical, max_speed);
    return *scheme.dt;
  }
  const bool changes = last == 0.0 || last > std::min(1.02 * wanted, critical) || last < 0.8 * wanted;
  return changes ? wanted : last;
}

} // namespace tremolo::mpm_domain
