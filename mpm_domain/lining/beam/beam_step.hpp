#pragma once

// A step of a beam by backward Euler: forces act for a time s (the kick), positions then move for dt,
//
//     A v+ = M v- - s (f(q) - f_ext),     A = M + s dt K,     q+ = q + dt v+,
//
// K = B^T D B being the material part of the tangent at q. It has no limit on dt, where an explicit beam
// would need some ten times as many steps as soil. It damps a mode of angular frequency omega with the ratio
// omega dt/2, little at the frequencies of an earthquake; Newmark's rule with beta = 1/4 would not damp at
// all, but gains energy where contact opens. K annihilates translations and rotations at q, so momentum and
// angular momentum are exact; with the geometric part of the tangent they would not be.
//
// A^-1 is the beam's answer to an impulse within the step, which contact works with.

#include "mpm_domain/lining/beam/beam.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

class BeamStep {
public:
  /// @param kick    s, s
  /// @param dt      s
  /// @param forces  f_ext, N/m and N, by degree of freedom
  /// @param keep    share of v- that is left, below 1 where the beam is to come to rest
  BeamStep(const Beam& beam, double kick, double dt, std::span<const double> forces, double keep = 1.0);

  /// The velocities without any impulse.
  const std::vector<double>& trial() const { return trial_; }
  /// X = A^-1 X.
  /// @param columns  of X, which stands in x row after row
  void answer(std::span<double> x, std::size_t columns = 1) const { admittance_.solve(x, columns); }

private:
  BandMatrix admittance_;
  std::vector<double> trial_;
};

} // namespace tremolo::mpm_domain
