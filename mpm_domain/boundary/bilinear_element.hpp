#pragma once

// The bilinear rectangle of matched layers, x from 0 to its width and z from 0 to its height, with nodes
//
//     0: (0, 0)    1: (width, 0)    2: (0, height)    3: (width, height)
//
// and two by two points of Gauss, at xi = x/width and zeta = z/height.

#include "coupler/eq6/boundary_traction.hpp"

#include <array>
#include <cstddef>
#include <numbers>

namespace tremolo::mpm_domain {

struct BilinearElement {
  using Vectors = std::array<eq6::Vector, 4>; ///< one of each node

  static constexpr std::size_t points = 4;
  /// The two points of Gauss in [0, 1].
  static constexpr std::array<double, 2> gauss{0.5 - 0.5 * std::numbers::inv_sqrt3,
                                               0.5 + 0.5 * std::numbers::inv_sqrt3};

  double width = 0.0;  ///< m
  double height = 0.0; ///< m

  /// du/dx, which is the same for all xi.
  [[nodiscard]] eq6::Vector along(const Vectors& u, double zeta) const {
    const double near = (1.0 - zeta) / width, far = zeta / width;
    return {near * (u[1].x - u[0].x) + far * (u[3].x - u[2].x),
            near * (u[1].y - u[0].y) + far * (u[3].y - u[2].y)};
  }

  /// du/dz, which is the same for all zeta.
  [[nodiscard]] eq6::Vector down(const Vectors& u, double xi) const {
    const double near = (1.0 - xi) / height, far = xi / height;
    return {near * (u[2].x - u[0].x) + far * (u[3].x - u[1].x),
            near * (u[2].y - u[0].y) + far * (u[3].y - u[1].y)};
  }

  /// Takes from the nodes' forces (N/m) what the stresses at a point, on planes across x and across z (Pa),
  /// pull at them.
  void pull(Vectors& force, double xi, double zeta, const eq6::Vector& on_x, const eq6::Vector& on_z) const {
    const double p = 0.25 * height, q = 0.25 * width; // a quarter of the area over width and height
    const auto take = [&](eq6::Vector& f, double nx, double nz) {
      f.x -= nx * p * on_x.x + nz * q * on_z.x;
      f.y -= nx * p * on_x.y + nz * q * on_z.y;
    };
    take(force[0], zeta - 1.0, xi - 1.0);
    take(force[1], 1.0 - zeta, -xi);
    take(force[2], -zeta, 1.0 - xi);
    take(force[3], zeta, xi);
  }
};

} // namespace tremolo::mpm_domain
