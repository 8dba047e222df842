#pragma once

#include <complex>
#include <vector>

namespace tremolo::materials {

/// Soil whose stress relaxes, as it stands in time: a law beside relaxation mechanisms (relaxation.cpp). Soil
/// without mechanisms is the law alone.
struct Relaxation {
  double relaxed = 1.0;       ///< G_R/G: stiffness when all mechanisms have relaxed, over that of the soil
  std::vector<double> time;   ///< tau_j, s
  std::vector<double> weight; ///< w_j = M_j/G_R

  bool acts() const { return !time.empty(); }
  /// G_U/G: stiffness when nothing has had the time to relax, over that of the soil.
  double unrelaxed() const;
  /// G*(s)/G.
  /// @param s  i omega + epsilon, 1/s
  std::complex<double> factor(std::complex<double> s) const;
  /// These mechanisms acting on a fraction (1) of a modulus, the rest of which does not relax: shear
  /// stiffness in the P-wave modulus of saturated soil.
  Relaxation on_share(double share) const;
};

/// Update of one mechanism's stress in a step of one length: q -> kept q + taken d sigma.
struct RelaxationStep {
  double kept = 1.0;
  double taken = 0.0;
};

/// @param dt  s
RelaxationStep relaxation_step(const Relaxation& relaxation, std::size_t mechanism, double dt);

} // namespace tremolo::materials
