#pragma once

#include <cmath>
#include <optional>

namespace tremolo::materials {

/// Isotropic elasticity with density. sigma = 2 G dev(eps) + K tr(eps) I.
struct Elasticity {
  double density = 0.0; ///< kg/m3
  double young = 0.0;   ///< Pa
  double poisson = 0.0; ///< 1, in (-1, 0.5)
  /// Horizontal over vertical stress before shaking, K0, where it is known otherwise than from elasticity.
  std::optional<double> at_rest = std::nullopt;

  double shear_modulus() const { return young / (2.0 * (1.0 + poisson)); }
  double bulk_modulus() const { return young / (3.0 * (1.0 - 2.0 * poisson)); }
  /// lambda = K - 2/3 G, Pa
  double lame() const { return young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)); }
  /// M = K + 4/3 G, Pa
  double p_modulus() const { return lame() + 2.0 * shear_modulus(); }
  /// c_p, m/s
  double p_wave_speed() const { return std::sqrt(p_modulus() / density); }
  /// c_s, m/s
  double s_wave_speed() const { return std::sqrt(shear_modulus() / density); }
  /// K0: as given, or nu/(1-nu), which is that under self weight without lateral strain
  double rest_coefficient() const { return at_rest.value_or(poisson / (1.0 - poisson)); }

  /// Elastic energy per unit volume at a stress (Pa, out-of-plane shear zero), J/m3
  double energy_density(double sxx, double syy, double szz, double sxy) const {
    const double trace = sxx + syy + szz;
    const double squares = sxx * sxx + syy * syy + szz * szz + 2.0 * sxy * sxy;
    return ((1.0 + poisson) * squares - poisson * trace * trace) / (2.0 * young);
  }

  /// @param vs, vp  wave speeds, m/s
  static Elasticity from_wave_speeds(double rho, double vs, double vp) {
    const double ratio = vs * vs / (vp * vp);
    const double nu = (0.5 - ratio) / (1.0 - ratio);
    return {.density = rho, .young = 2.0 * rho * vs * vs * (1.0 + nu), .poisson = nu};
  }
};

} // namespace tremolo::materials
