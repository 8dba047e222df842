#pragma once

#include "wavefield/half_space.hpp"

#include <array>
#include <complex>

namespace tremolo::wavefield {

/// One of the plane waves that make up the field, for angular frequencies > 0 (conjugate below): with an
/// incident velocity spectrum F at depth y = 0 below the surface, each quantity's spectrum is coefficient F
/// exp(-i omega (p x + q y)).
struct PlaneWave {
  std::complex<double> q;             ///< vertical slowness, s/m; negative downwards; imaginary if evanescent
  std::complex<double> vx, vy;        ///< per unit incident velocity
  std::complex<double> sxx, syy, sxy; ///< Pa s/m, tension positive
};

/// Incident, reflected P, reflected S, in this order.
using PlaneWaves = std::array<PlaneWave, 3>;

/// The incident wave and what a free surface at y = 0 reflects, so that sxy = syy = 0 there.
PlaneWaves plane_waves(const HalfSpace& half_space, const Incidence& incidence);

} // namespace tremolo::wavefield
