#pragma once

namespace tremolo::wavefield {

/// Homogeneous, isotropic, undamped elastic half-space under a horizontal free surface.
struct HalfSpace {
  double density = 0.0; ///< kg/m3
  double vs = 0.0;      ///< shear wave speed b, m/s
  double vp = 0.0; ///< compressional wave speed a, m/s; a^2 > 4/3 b^2, so that the bulk modulus is positive
};

enum class WaveType { SV, P };

/// An incident plane wave that travels to +x and +y (upwards).
struct Incidence {
  WaveType wave = WaveType::SV;
  double angle_rad = 0.0;   ///< from the vertical, in [0, pi/2)
  double x_reference = 0.0; ///< m; where the incident wave alone has exactly the given signal
  double y_reference = 0.0; ///< m
};

/// Horizontal slowness p = sin(angle) / c, s/m, c the incident wave's speed: the field at x is the field at
/// x_0 delayed by p (x - x_0), at every depth.
double slowness_x(const HalfSpace& half_space, const Incidence& incidence);

/// Incident SV beyond asin(vs/vp): the reflected P wave is evanescent. Never true of an incident P wave.
bool is_post_critical(const HalfSpace& half_space, const Incidence& incidence);

/// @throws std::invalid_argument naming the quantity, its value and the allowed range
void validate(const HalfSpace& half_space);
void validate(const Incidence& incidence);

} // namespace tremolo::wavefield
