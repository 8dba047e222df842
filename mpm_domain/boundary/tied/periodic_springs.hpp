#pragma once

// Periodic sides by a penalty: stiff springs between the side particles of equal height, turned into
// tractions on their faces,
//
//     t_left = f^st + k (u_right - u_left),      t_right = f^st - k (u_right - u_left),
//
// with u the particle's displacement since rest. Two half cells of rho h/2 on a spring turn at 4k/(rho h);
// with
//
//     k = rho h / (4 dt^2)
//
// that is 1/dt^2, a quarter of what leapfrog bears. At half of the critical step it is 2.4 rho c_p^2/h: the
// seam gives way as 0.4 cells more would, an error of first order in h, where the wrapped grid
// (periodic_sides.hpp) has none.

#include "mpm_domain/boundary/support.hpp"

namespace tremolo::mpm_domain {

class PeriodicSprings final : public Support {
public:
  /// Ties the sides of a domain at rest.
  /// @throws std::invalid_argument where the particles along the sides do not face each other
  PeriodicSprings(const Ground& ground, std::span<BoundaryFace> faces);

  std::string name() const override { return "springs between the sides"; }
  /// Sets the free field of the sides' faces too: what each meets beyond the seam, the velocity of the
  /// opposite face.
  void exchange(const Exchange& at, std::span<SupportLoad> loads) override;

private:
  std::vector<double> stiffness_; ///< of a pair, Pa/m, upwards
};

} // namespace tremolo::mpm_domain
