#pragma once

#include "freefield/profile.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::freefield {

/// Nodes from the base (index 0) to the surface; element e joins nodes e and e+1. Layer interfaces are nodes.
struct ColumnMesh {
  std::vector<double> node_y;             ///< m, ascending
  std::vector<std::size_t> element_layer; ///< index into Profile::layers, one an element

  std::size_t elements() const { return element_layer.size(); }
  double length(std::size_t element) const { return node_y[element + 1] - node_y[element]; }

  /// A place in the mesh: an element and the fraction of its length from its lower node, in [0, 1].
  struct Place {
    std::size_t element = 0;
    double fraction = 0.0;
  };

  enum class Side { below, above };

  /// The position of level y in the mesh. A node belongs to the element on the requested side, the surface to
  /// the last one and the base to the first. A level within rounding of a node, 1e-9 of the height, is that
  /// node.
  /// @throws std::invalid_argument if y lies outside the mesh by more than rounding
  Place at(double y, Side side = Side::above) const;

  /// The element centres of one layer around a place: a quantity known at centres and smooth within a layer
  /// is (1 - weight) lower + weight upper there, to second order. Weights beyond [0, 1] extrapolate to the
  /// layer's edges; both are the same in a layer of one element.
  struct Centres {
    std::size_t lower = 0;
    std::size_t upper = 0;
    double weight = 0.0;
  };
  Centres centres(const Place& place) const;
};

/// @throws std::invalid_argument if the element size is not positive or asks for more than a million elements
ColumnMesh mesh_profile(const Profile& profile, double max_element_size);

} // namespace tremolo::freefield
