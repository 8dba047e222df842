#pragma once

// The section of a plate of thickness t that bends in plane strain, per metre out of plane:
//
//     EA = D' t,     EI = D' t^3/12,     GA_s = (5/6) G t,     D' = E/(1 - nu^2),     G = E/(2 (1 + nu)),
//
// with masses rho t along its length and rho t^3/12 in rotation. The factor 5/6 is that of a rectangle whose
// shear stress is a parabola (Reissner 1945).

#include "base/vector.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

struct BeamSection {
  double axial = 0.0;   ///< EA, N/m
  double shear = 0.0;   ///< GA_s, N/m; infinite: sections stay normal to the axis (Euler-Bernoulli)
  double bending = 0.0; ///< EI, N m
  double mass = 0.0;    ///< rho t, kg/m2
  double rotary = 0.0;  ///< rho t^3/12, kg
};

/// @param thickness  t, m
/// @param young      E, Pa
/// @param density    rho, kg/m3
constexpr BeamSection plate_section(double thickness, double young, double poisson, double density) {
  const double plane_strain = young / (1.0 - poisson * poisson);
  const double cube = thickness * thickness * thickness / 12.0;
  return {.axial = plane_strain * thickness,
          .shear = 5.0 / 6.0 * young / (2.0 * (1.0 + poisson)) * thickness,
          .bending = plane_strain * cube,
          .mass = density * thickness,
          .rotary = density * cube};
}

/// A lining that keeps a cavity in the soil open: a closed beam behind the surface that the soil touches.
struct Lining {
  std::string name;
  /// Corners of that surface, counter-clockwise, m. Each stands in front of a node of the beam.
  std::vector<Vector> outline;
  double thickness = 0.0; ///< t, m; the axis of the beam lies t/2 behind the surface
  BeamSection section;
  std::vector<std::size_t> hinges; ///< numbers of the corners where no moment passes
  std::vector<double> friction;    ///< mu against each soil of the spec
  std::vector<double> adhesion;    ///< against each soil, Pa
};

} // namespace tremolo::mpm_domain
