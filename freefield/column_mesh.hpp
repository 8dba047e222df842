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

  /// Where level y lies; a node belongs to the element above it, the surface to the last one.
  /// @throws std::invalid_argument if y lies outside the mesh by more than rounding, 1e-9 of its height
  Place at(double y) const;
};

/// @throws std::invalid_argument if the element size is not positive or asks for more than a million elements
ColumnMesh mesh_profile(const Profile& profile, double max_element_size);

} // namespace tremolo::freefield
