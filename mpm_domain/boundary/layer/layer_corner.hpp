#pragma once

// The corner between the matched layers of a side and of the base: a block as deep as the layers, stretched
// in both directions. With x the side's outward direction and z that of the base, both from 0 at the domain's
// corner to d, and the stretches g_x(x), g_z(z) of layer_stretch.hpp, the equations of motion
//
//     rho i omega w = 1/g_x ds_x/dx + 1/g_z ds_z/dz,    e_x = 1/g_x du/dx,    e_z = 1/g_z du/dz
//
// (w velocity, e displacement gradient, s_x and s_z the stresses on planes across x and z) times g_x g_z are
//
//     rho (dw/dt + (b_x + b_z)(w - a Z) + b_x b_z (Z - a Y)) = d/dx (s_x + b_z S_x) + d/dz (s_z + b_x S_z),
//     dZ/dt = w - a Z,    dY/dt = Z - a Y,    dS_x/dt = s_x - a S_x,    dS_z/dt = s_z - a S_z,
//     e_x = du/dx - b_x Q_x,    dQ_x/dt = du/dx - (a + b_x) Q_x,    and so for z,
//
// with Z, Y memories of each node, Q of each integration point, S_x of each of their depths z and S_z of each
// x (layer_lattice.hpp). Where z = 0, b_z = 0, and these are the equations of the side's layer
// (layer_lattice.hpp), which goes on there; where x = 0 those of the base's. So nothing is reflected where a
// wave passes from one into the other (Basu and Chopra 2004, sec. 4.2).
//
// The block's nodes at z = 0 are the last ones of the side's layer, those at x = 0 of the base's layer, and
// all move as one mass. The node at x = z = 0 is the domain's own: it moves with the mean of the two layers'
// nodes there, and each of them gets half of its force and mass.

#include "coupler/eq6/boundary_traction.hpp"
#include "mpm_domain/boundary/layer/bilinear_element.hpp"
#include "mpm_domain/boundary/layer/layer_lattice.hpp"
#include "mpm_domain/fields/saved_numbers.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Sizes and material of the corner's elements.
struct CornerShape {
  double density = 0.0;       ///< kg/m3
  double p_modulus = 0.0;     ///< rho c_p^2, Pa
  double shear_modulus = 0.0; ///< rho c_s^2, Pa
  double depth = 0.0;         ///< d, m
  int cells = 0;              ///< over the depth
  LayerStretch stretch;
};

/// Motion in the corner's own directions x, z.
class LayerCorner {
public:
  explicit LayerCorner(const CornerShape& shape);

  /// Advances by dt (s) while the domain's corner moves at the given velocity (m/s).
  /// @param side, base  forces of the layers at the nodes that they share with the corner, at the time before
  void advance(double dt, const eq6::Vector& corner_velocity, const LayerEndNodes& side,
               const LayerEndNodes& base);

  /// Velocity (m/s) of the node that is j elements away from the domain's corner behind the side, at z = 0.
  [[nodiscard]] eq6::Vector side_velocity(std::size_t j) const { return v_[node(j, 0)]; }
  /// Velocity (m/s) of the node that is j elements away from it behind the base, at x = 0.
  [[nodiscard]] eq6::Vector base_velocity(std::size_t j) const { return v_[node(0, j)]; }

  /// Force of the block on the domain's corner, without its inertia, N/m.
  [[nodiscard]] eq6::Vector corner_force() const { return force_.front(); }
  /// Mass of the block at the domain's corner, kg/m.
  [[nodiscard]] double corner_mass() const { return mass_.front(); }

  /// Adds all that changes with time, for a checkpoint.
  void add_state(SavedNumbers& state);

private:
  /// Memory variables of an element.
  struct Memory {
    struct Q {
      eq6::Vector x, z;
    };
    std::array<Q, gauss_points> q;                ///< [zeta][xi]
    std::array<eq6::Vector, gauss.size()> sx, sz; ///< of each zeta, of each xi
  };

  void move_node(std::size_t i, std::size_t j, double dt, double mass, eq6::Vector force);
  void sum_forces(double dt);
  void strain_element(std::size_t column, std::size_t row, std::span<const StretchAt> stretches,
                      const Decay& stress_decay);
  [[nodiscard]] std::size_t node(std::size_t i, std::size_t j) const { return j * (cells_ + 1) + i; }

  CornerShape shape_;
  std::size_t cells_;
  double size_; ///< of an element, m
  std::vector<double> mass_;
  std::vector<eq6::Vector> u_, v_, z_, y_, force_;
  std::vector<Memory> memory_;
};

} // namespace tremolo::mpm_domain
