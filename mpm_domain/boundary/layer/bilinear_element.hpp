#pragma once

// The bilinear rectangle of matched layers, x from 0 to its width and z from 0 to its height, with nodes
//
//     0: (0, 0)    1: (width, 0)    2: (0, height)    3: (width, height)
//
// and two by two points of Gauss, at xi = x/width and zeta = z/height: one element, whose vectors are of
// double, or four side by side, whose vectors are of Lanes.

#include <array>
#include <cstddef>
#include <numbers>

namespace tremolo::mpm_domain {

/// The two points of Gauss in [0, 1].
inline constexpr std::array<double, 2> gauss{0.5 - 0.5 * std::numbers::inv_sqrt3,
                                             0.5 + 0.5 * std::numbers::inv_sqrt3};
inline constexpr std::size_t gauss_points = gauss.size() * gauss.size();

template <typename Vector>
struct BilinearElement {
  using Real = decltype(Vector::x);
  using Vectors = std::array<Vector, 4>; ///< one of each node

  Real width{};        ///< m
  double height = 0.0; ///< m

  /// du/dx, which is the same for all xi.
  [[nodiscard]] Vector along(const Vectors& u, double zeta) const {
    const Real near = (1.0 - zeta) / width, far = zeta / width;
    return {near * (u[1].x - u[0].x) + far * (u[3].x - u[2].x),
            near * (u[1].y - u[0].y) + far * (u[3].y - u[2].y)};
  }

  /// du/dz, which is the same for all zeta.
  [[nodiscard]] Vector down(const Vectors& u, double xi) const {
    const double near = (1.0 - xi) / height, far = xi / height;
    return {near * (u[2].x - u[0].x) + far * (u[3].x - u[1].x),
            near * (u[2].y - u[0].y) + far * (u[3].y - u[1].y)};
  }

  /// Takes from the nodes' forces (N/m) what stresses on planes across x (Pa) at a depth pull at them. What
  /// they pull depends on zeta alone, so that the stresses of both xi come in as their sum.
  void pull_across(Vectors& force, double zeta, const Vector& on_x) const {
    const double p = 0.25 * height; // a quarter of the area over the width
    const Vector near{(1.0 - zeta) * p * on_x.x, (1.0 - zeta) * p * on_x.y};
    const Vector far{zeta * p * on_x.x, zeta * p * on_x.y};
    add(force[0], near), take(force[1], near), add(force[2], far), take(force[3], far);
  }

  /// Adds the nodal forces of stresses on planes across z at one xi, summed over both zeta.
  void pull_down(Vectors& force, double xi, const Vector& on_z) const {
    const Real q = 0.25 * width; // a quarter of the area over the height
    const Vector near{(1.0 - xi) * (q * on_z.x), (1.0 - xi) * (q * on_z.y)};
    const Vector far{xi * (q * on_z.x), xi * (q * on_z.y)};
    add(force[0], near), add(force[1], far), take(force[2], near), take(force[3], far);
  }

private:
  static void add(Vector& force, const Vector& by) {
    force.x += by.x;
    force.y += by.y;
  }
  static void take(Vector& force, const Vector& by) {
    force.x -= by.x;
    force.y -= by.y;
  }
};

} // namespace tremolo::mpm_domain
