#pragma once

// The faces that a rank works out: their weights, velocity and forces. One process works out all. Ranks that
// share the ground work out those whose forces come to nodes in the windows of their tiles: the faces that
// touch these nodes, and those from which the consistent dashpots reach them in three steps. Each counts, in
// the ledger, where its particle is. From that rank its velocity goes to the first one, which exchanges it
// for the free field, and to all where supports look at more than their own faces.
//
// Where levels take steps of their own, and on a graded mesh with periodic sides, each rank works out all
// faces.

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
  /// @param by_face  whether supports look at nothing but their own faces (Support::is_by_face)
  void follow_sort(const Ground& ground, std::span<const BoundaryFace> faces, const SoilAtFaces& soil,
                   bool by_face);

  std::span<const std::size_t> all() const { return near_; } ///< rising
  /// Whether other ranks than the first need to know nothing of the faces that they do not work out.
  bool are_enough() const { return lacks_some_ && by_face_; }
  /// The faces that count here come in groups. The particles of a group lie in one tile, and so on one rank.
  std::size_t group_count() const { return groups_.empty() ? 0 : groups_.size() - 1; }
  std::span<const std::size_t> group(std::size_t number) const {
    return std::span(own_).subspan(groups_[number], groups_[number + 1] - groups_[number]);
  }
  /// The first rank has the velocities of all faces; all others too, unless near ones are enough for them.
  /// @param velocities  of several kinds, each by face
  /// @returns whether each had but some: where each has worked out all, nothing happens
  bool share(const Ground& ground, std::span<const std::span<Vector>> velocities);

private:
  void find_groups(const Ground& ground, std::span<const BoundaryFace> faces);

  std::vector<std::size_t> near_, own_;
  std::vector<std::size_t> groups_; ///< where they begin among its own, and the end
  SharedList owners_;
  bool lacks_some_ = false;
  bool by_face_ = false;
  std::vector<double> numbers_; ///< of a message
};

} // namespace tremolo::mpm_domain
