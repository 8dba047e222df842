#include "mpm_domain/step/stepper.hpp"

#include "mpm_domain/step/recipe.hpp"
#include "mpm_domain/transfer/out_of_reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace tremolo::mpm_domain {

Stepper::Stepper(Domain& domain, double start_time, const FreeFieldSource& free_field)
    : domain_(domain), step_(domain, domain.energy, start_time) {
  passes_ = recipe(domain, free_field);
  step_.max_speed = fastest_point(domain);
  find_bounds();
  step_.dt = next_time_step(domain, step_.bounds, step_.max_speed, 0.0);
}

void Stepper::run(std::span<Pass> passes) {
  using Clock = std::chrono::steady_clock;
  Clock::time_point before = Clock::now();
  for (Pass& pass : passes) {
    pass.run(step_);
    const Clock::time_point after = Clock::now();
    pass.seconds += std::chrono::duration<double>(after - before).count();
    before = after;
  }
}

void Stepper::step() {
  const auto ticking =
      std::ranges::find_if_not(passes_, [](const Pass& pass) { return is_once_a_step(pass.phase); });
  try {
    run({passes_.begin(), ticking});
    do {
      run({ticking, passes_.end()});
      if (step_.fastest > 0.0)
        step_.max_speed = step_.fastest;
    } while (step_.ticks.next());
  } catch (const OutOfReach& error) {
    throw std::runtime_error(
        fmt::format("{} (t = {:.6g} s, step {})", error.what(), step_.time, step_.count));
  }
  step_.moved += step_.pushed;
  step_.moved += step_.max_speed * step_.dt;
  step_.pushed = 0.0;
  updates_ += particle_updates_per_step(domain_);
  step_.time += step_.dt;
  ++step_.count;
}

std::vector<PassTime> Stepper::times() const {
  std::vector<PassTime> times;
  for (const Pass& pass : passes_)
    if (pass.name.empty())
      times.back().seconds += pass.seconds;
    else
      times.push_back({pass.name, pass.seconds});
  return times;
}

double Stepper::time_of_soil(double simulated) const {
  return domain_.spec.clock.time_of_soil(simulated);
}

double Stepper::speed_of_time() const {
  return domain_.spec.clock.speed(velocity_time());
}

void Stepper::find_bounds() {
  step_.bounds = step_bounds(domain_);
  take_largest(domain_, step_.bounds);
}

} // namespace tremolo::mpm_domain
