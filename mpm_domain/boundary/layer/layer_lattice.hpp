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
// with Z a memory of each node, Q of each integration point and S, of the stress on planes across x, of each
// depth of points: what it pulls at the nodes depends on depth alone, and sums decay as their parts do. At
// rest g = 1 + b/a: the layer then stands for ground of finite depth on rigid rock and holds what is put on
// it.

#include "coupler/eq6/boundary_traction.hpp"
#include "mpm_domain/boundary/layer/bilinear_element.hpp"
#include "mpm_domain/boundary/layer/layer_stretch.hpp"
#include "mpm_domain/fields/saved_numbers.hpp"
#include "mpm_domain/tiles/worker_pool.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// A column of elements and its material.
struct LayerColumn {
  double width = 0.0;         ///< along the boundary, m
  double density = 0.0;       ///< kg/m3
  double p_modulus = 0.0;     ///< rho c_p^2, Pa
  double shear_modulus = 0.0; ///< rho c_s^2, Pa
};

/// Condition at the first and at the last column.
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
  /// Force of the layer on one of its boundary nodes, without its inertia, N/m.
  [[nodiscard]] eq6::Vector boundary_force(std::size_t node) const { return force_.at(node); }
  /// Mass of the layer at its nodes on the boundary, kg/m.
  [[nodiscard]] std::span<const double> boundary_mass() const { return std::span(mass_).first(across_); }

  [[nodiscard]] const LayerShape& shape() const { return shape_; }
  [[nodiscard]] const LayerStretch& stretch() const { return stretch_; }

  /// The nodes of an end, 0 or 1.
  [[nodiscard]] LayerEndNodes end_nodes(std::size_t end) const;
  /// Sets the velocity (m/s), in the next step, of the node j elements behind the boundary at an end: a
  /// corner leads the nodes of its end.
  void lead(std::size_t end, std::size_t j, eq6::Vector velocity) { v_.set(end_node(end, j), velocity); }
  /// Adds mass (kg/m) of a corner to the node on the boundary, once and for all.
  void add_corner_mass(std::size_t end, double mass) { mass_[end_node(end, 0)] += mass; }
  /// Adds the force (N/m) of a corner to the node on the boundary, after every step.
  void add_corner_force(std::size_t end, eq6::Vector force);

  /// Adds all that changes with time, for a checkpoint.
  void add_state(SavedNumbers& state);

private:
  /// A vector of each node, by component: four neighbours are worked on at a time.
  struct NodeVectors {
    std::vector<double> x, y;
    [[nodiscard]] eq6::Vector at(std::size_t node) const { return {x[node], y[node]}; }
    void set(std::size_t node, eq6::Vector value) { x[node] = value.x, y[node] = value.y; }
  };
  /// Number of an element's memory variables: Q of each integration point and S (of s_xx and s_xz) of each of
  /// their depths, two components each.
  static constexpr std::size_t memories = 2 * (gauss_points + gauss.size());
  /// Properties of a row of elements: the stretch at the two depths of its integration points.
  struct Row {
    std::size_t index;
    std::array<StretchAt, 2> stretches;
    Decay stress_decay;
  };

  void lump();
  void move(double dt, std::span<const eq6::Vector> boundary_velocity, WorkerPool& workers);
  void kick_row(std::size_t row, double dt);
  /// Adds to forces that move() has cleared.
  void sum_forces(double dt, WorkerPool& workers);
  void strain(const Row& row, std::size_t first_column, std::size_t last_column);
  template <typename Group>
  void strain_elements(const Row& row, std::size_t column, Group group);
  [[nodiscard]] std::size_t end_node(std::size_t end, std::size_t j) const {
    return node(end == 0 ? 0 : across_ - 1, j);
  }
  [[nodiscard]] std::size_t node(std::size_t i, std::size_t j) const { return j * across_ + i % across_; }

  LayerShape shape_;
  LayerStretch stretch_;
  std::size_t across_ = 0; ///< nodes along the boundary

  std::vector<double> mass_;
  NodeVectors end_dashpot_; ///< of each node, Pa s
  NodeVectors u_, v_, z_, force_;
  std::vector<double> p_modulus_, shear_modulus_, width_; ///< of each column
  std::vector<double> memory_; ///< [row][depth][Q of each xi, then S][component][column]
};

} // namespace tremolo::mpm_domain
