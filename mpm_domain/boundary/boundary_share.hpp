#pragma once

// What ranks that share a domain tell each other of its boundary. Faces and their nodes are few, and the
// consistent dashpots tie every node to its neighbours along the side. So every rank works out all of the
// boundary, with the same bits: for that it is told where the particles of all faces are, and the sums at all
// nodes that faces may touch until the next sort.

#include "mpm_domain/boundary/boundary_faces.hpp"
#include "mpm_domain/fields/node_fields.hpp"
#include "mpm_domain/ranks/shared_list.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

struct Ground;

class BoundaryShare {
public:
  /// To be made by all ranks after each sort.
  BoundaryShare(const Ground& ground, std::span<const BoundaryFace> faces);

  /// Tells of the soil at the faces, and the sums at the nodes, in one message.
  /// @param soil  by face; takes what all ranks tell
  void tell(Ground& ground, std::span<const BoundaryFace> faces, std::span<FaceSoil> soil);
  std::span<const std::size_t> nodes() const { return nodes_; } ///< rising

private:
  SharedList faces_;
  std::vector<std::size_t> nodes_;
  SharedList sums_; ///< at nodes_
  std::vector<double> numbers_;
};

} // namespace tremolo::mpm_domain
