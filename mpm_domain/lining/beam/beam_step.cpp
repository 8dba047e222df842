#include "mpm_domain/lining/beam/beam_step.hpp"

namespace tremolo::mpm_domain {

BeamStep::BeamStep(const Beam& beam, double kick, double dt, std::span<const double> forces, double keep)
    : admittance_(beam.empty_matrix()), trial_(beam.internal_forces()) {
  beam.add_stiffness(kick * dt, admittance_);
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const double m = beam.masses()[i];
    admittance_.add(i, i, m);
    trial_[i] = keep * m * beam.velocities()[i] - kick * (trial_[i] - forces[i]);
  }
  admittance_.factorise();
  admittance_.solve(trial_);
}

} // namespace tremolo::mpm_domain
