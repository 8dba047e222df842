#pragma once

// A perfectly matched layer of an isotropic elastic half-space behind a straight boundary: bilinear finite
// elements whose depth coordinate z is stretched (Berenger 1994; unsplit and shifted in frequency as by Basu
// and Chopra 2004, Kuzuoglu and Mittra 1996),
//
//     d/dz -> (1/g) d/dz,        g(z, omega) = 1 + b(z)/(a + i omega),        b = b_max (z/d)^2
//
// (layer_stretch.hpp).
// A wave that enters is not reflected, whatever its angle, but dies away, and comes back from the fixed end
// at depth d as exp(-2 cos(theta)/c int b dz) of itself. With w the velocity, e the displacement gradient and
// x along the boundary, the stretched equations of motion times g are
//
//     rho (dw/dt + b (w - a Z)) = d/dx (s_x + b S) + d/dz s_z,     dZ/dt = w - a Z,   dS/dt = s_x - a S,
//     e_z = du/dz - b Q,                                           dQ/dt = du/dz - (a + b) Q,
//
// with Z a memory of each node, S (of the stress on planes across x) and Q memories of each integration
// point. At rest g = 1 + b/a: the layer then stands for ground of finite depth on rigid rock and holds what
// is put on it.

#include "coupler/eq6/boundary_traction.hpp"
#include "mpm_domain/boundary/bilinear_element.hpp"
#include "mpm_domain/boundary/layer/layer_stretch.hpp"
#include "mpm_domain/tiles/worker_pool.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// A column of elements and what it is made of.
struct LayerColumn {
  double width = 0.0;         ///< along the boundary, m
  double density = 0.0;       ///< kg/m3
  double p_modulus = 0.0;     ///< rho c_p^2, Pa
  double shear_modulus = 0.0; ///< rho c_s^2, Pa
};

/// What lies beyond the first and the last column.
enum class LayerEnd {
  dashpots, ///< more of the same layer, by dashpots stretched like it
  free,     ///< nothing
  repeated, ///< the other end; of both
  corner,   ///< a block stretched in both directions, which leads the nodes of this end (layer_corner.hpp)
};

struct LayerShape {
  std::vector<LayerColumn> columns;
  double depth = 0.0; ///< d, m
  int cells = 0;      ///< elements over the depth
  /// P wave that the stretch is made for, m/s: the fastest of all layers that meet at corners. Without it,
  /// the fastest of the columns.
  std::optional<double> fastest = std::nullopt;
  std::array<LayerEnd, 2> ends{LayerEnd::dashpots, LayerEnd::dashpots};
};

/// The nodes of one end, from the one on the boundary to the fixed one.
struct LayerEndNodes {
  std::vector<double> mass;       ///< kg/m
  std::vector<eq6::Vector> force; ///< what the layer exerts on them, N/m
};

/// Motion in the layer's own directions: x along the boundary, y its outward normal.
class LayerLattice {
public:
  /// @throws std::invalid_argument for a shape that is empty or has a value that is not positive
  explicit LayerLattice(LayerShape shape);

  /// Advances the layer by dt (s) while its nodes on the boundary move at the given velocities (m/s). Blocks
  /// of columns have two colours, and blocks of one colour share no node, so no two threads write to one
  /// node.
  void advance(double dt, std::span<const eq6::Vector> boundary_velocity, WorkerPool& workers);

  /// Nodes on the boundary.
  [[nodiscard]] std::size_t width() const { return across_; }
  /// What the layer exerts on its nodes on the boundary, besides their inertia, N/m.
  [[nodiscard]] std::span<const eq6::Vector> boundary_force() const {
    return std::span(force_).first(across_);
  }
  /// Mass of the layer at its nodes on the boundary, kg/m.
  [[nodiscard]] std::span<const double> boundary_mass() const { return std::span(mass_).first(across_); }

  [[nodiscard]] const LayerShape& shape() const { return shape_; }
  [[nodiscard]] const LayerStretch& stretch() const { return stretch_; }

  /// The nodes of an end, 0 or 1.
  [[nodiscard]] LayerEndNodes end_nodes(std::size_t end) const;
  /// Sets the velocity (m/s), in the next step, of the node j elements behind the boundary at an end: a
  /// corner leads the nodes of its end.
  void lead(std::size_t end, std::size_t j, eq6::Vector velocity) { v_[end_node(end, j)] = velocity; }
  /// Adds mass (kg/m) of a corner to the node on the boundary, once and for all.
  void add_corner_mass(std::size_t end, double mass) { mass_[end_node(end, 0)] += mass; }
  /// Adds the force (N/m) of a corner to the node on the boundary, after every step.
  void add_corner_force(std::size_t end, eq6::Vector force);

  /// All that changes with time, for a checkpoint.
  [[nodiscard]] std::vector<double> state() const;
  /// @throws std::invalid_argument for a state of another shape
  void restore(std::span<const double> state);

private:
  /// What an integration point remembers.
  struct Memory {
    eq6::Vector q; ///< Q
    eq6::Vector s; ///< S: of s_xx and s_xz
  };
  /// Decays of the memory Q at the two depths where the integration points of a row of elements lie.
  using StrainDecays = std::array<Decay, 2>;

  void lump();
  void move(double dt, std::span<const eq6::Vector> boundary_velocity, WorkerPool& workers);
  void sum_forces(double dt, WorkerPool& workers);
  void strain_element(std::size_t column, std::size_t row, const Decay& stress_decay,
                      const StrainDecays& strain_decays);
  [[nodiscard]] std::size_t end_node(std::size_t end, std::size_t j) const {
    return node(end == 0 ? 0 : across_ - 1, j);
  }
  [[nodiscard]] bool is_led(std::size_t node) const {
    const std::size_t i = node % across_;
    return (i == 0 && shape_.ends[0] == LayerEnd::corner) ||
           (i == across_ - 1 && shape_.ends[1] == LayerEnd::corner);
  }
  [[nodiscard]] std::size_t node(std::size_t i, std::size_t j) const { return j * across_ + i % across_; }

  LayerShape shape_;
  LayerStretch stretch_;
  std::size_t across_ = 0; ///< nodes along the boundary

  std::vector<double> mass_;
  std::vector<double> damping_;          ///< b of each node, 1/s
  std::vector<eq6::Vector> end_dashpot_; ///< of each node, Pa s
  std::vector<eq6::Vector> u_, v_, z_, force_;
  std::vector<Memory> memory_;
};

} // namespace tremolo::mpm_domain
