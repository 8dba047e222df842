#pragma once

// The faces that a rank works out: their weights, velocity and forces. One process works out all. Ranks that
// share the ground work out those whose forces come to nodes in the windows of their tiles: the faces that
// touch these nodes, and those from which the consistent dashpots reach them in three steps. Each counts, in
// the ledger, where its particle is. The velocities of all faces then come from the ranks on which they
// count.
//
// Where there is pore water, where sides are periodic, and where levels take steps of their own, each rank
// works out all faces.

#include "mpm_domain/boundary/boundary_faces.hpp"
#include "mpm_domain/boundary/face_soil.hpp"
#include "mpm_domain/ranks/shared_list.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

class NearFaces {
public:
  /// After a sort.
  void follow_sort(const Ground& ground, std::span<const BoundaryFace> faces, const SoilAtFaces& soil);

  std::span<const std::size_t> all() const { return near_; } ///< rising
  /// Whether ranks work out some faces each, and not all.
  bool lacks_some() const { return lacks_some_; }
  /// The faces that count here come in groups. The particles of a group lie in one tile, and so on one rank.
  std::size_t group_count() const { return groups_.empty() ? 0 : groups_.size() - 1; }
  std::span<const std::size_t> group(std::size_t number) const {
    return std::span(own_).subspan(groups_[number], groups_[number + 1] - groups_[number]);
  }
  /// Every rank has the velocities of all faces.
  /// @returns whether some came from others: where each has worked out all, nothing happens
  bool share(const Ground& ground, std::span<Vector> velocities);

private:
  void find_groups(const Ground& ground, std::span<const BoundaryFace> faces);

  std::vector<std::size_t> near_, own_;
  std::vector<std::size_t> groups_; ///< where they begin among its own, and the end
  SharedList owners_;
  bool lacks_some_ = false;
  std::vector<double> numbers_; ///< of a message
};

} // namespace tremolo::mpm_domain
