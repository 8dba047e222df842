#pragma once

#include "mpm_domain/domain.hpp"
#include "mpm_domain/passes/pass.hpp"
#include "mpm_domain/state.hpp"
#include "mpm_domain/step/time_step.hpp"

#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// Time that passes of one name have taken.
struct PassTime {
  std::string name;
  double seconds = 0.0;
};

/// Advances a domain in time, by leapfrog: positions and stresses are known at time(), velocities of
/// particles at velocity_time(), half a step before. A step is the list of passes of the recipe (recipe.hpp),
///
///     m_i = sum S m_p,   p_i = sum S m_p (v_p + C_p (x_i - x_p)),   v- = p_i/m_i
///     f_i = sum (S m_p g - V_p sigma_p grad S) + sum over faces l W t,   t of Eq. (6)
///     m_i (v+ - v-) = kick f_i,   then impulses between soil and structures
///     v_p = sum S v+  (apic)   or   v_p += sum S (v+ - v-)  (flip)
///     u_i = p_i/m_i of the new v_p  (musl)   or   u = v+  (usl)
///     x_p += dt sum S v+,   e_p += dt sym(sum u grad S),   sigma_p by the law,   pore pressure by div u
///
/// whose details stand where the passes come from. Passes after the sort run at every tick for the clocks
/// that begin or end a step of theirs with it (clocks/ticks.hpp).
class Stepper {
public:
  /// Makes a domain at rest ready to step.
  /// @param free_field gives the faces their free field; never called for a domain without faces
  /// @throws std::invalid_argument if the spec's fixed time step is over the critical one, or if the domain
  /// has faces and nobody gives their free field
  Stepper(Domain& domain, double start_time, const FreeFieldSource& free_field);

  void step();

  const Domain& domain() const { return domain_; }
  double time() const { return step_.time; }
  double velocity_time() const { return step_.time - 0.5 * step_.dt; }
  /// The soil's own time at a time of the simulation, s, and how many times as fast it passes where the
  /// velocities are (1): both differ in a rest alone (materials/water/soil_clock.hpp).
  double time_of_soil(double simulated) const;
  double time_of_soil() const { return time_of_soil(velocity_time()); }
  double speed_of_time() const;
  double dt() const { return step_.dt; }     ///< of the step just made, or of the first
  double kick() const { return step_.kick; } ///< time that the forces of the step just made have acted for, s
  long steps() const { return step_.count; }
  /// Particle updates by this stepper, summed over all particles.
  double particle_updates() const { return updates_; }
  std::vector<PassTime> times() const;

  /// Its part of a checkpoint (state.hpp).
  template <class Writer>
  void save(Writer& to) const {
    step_.save(to);
  }
  /// Goes on from there; the domain has been restored already.
  template <class Reader>
  void restore(const Reader& from) {
    step_.restore(from);
    follow_clock(domain_, step_.time);
    find_bounds();
  }

private:
  void run(std::span<Pass> passes);
  void find_bounds();

  Domain& domain_;
  Step step_;
  std::vector<Pass> passes_;
  double updates_ = 0.0;
};

} // namespace tremolo::mpm_domain
