#pragma once

// The soil at the faces: where it is, and its stress and pore pressure.
//
// Ranks that share a domain exchange it. The consistent dashpots tie every node to its neighbours along the
// side, so that a rank works out the faces near its tiles too (near/near_faces.hpp), with the same bits as
// others: for that it receives where their particles are, and the sums at all nodes that they may touch until
// the next sort. Where every rank works out all of the boundary, where supports look at all of it, and where
// structures may touch its nodes, it receives these of all faces.

#include "mpm_domain/boundary/boundary_faces.hpp"
#include "mpm_domain/fields/node_fields.hpp"
#include "mpm_domain/ranks/shared_list.hpp"
#include "mpm_domain/ranks/trade.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

class SoilAtFaces {
public:
  /// After a sort: finds what ranks exchange until the next one; all of them must call it.
  void follow_sort(const Ground& ground, std::span<const BoundaryFace> faces);
  /// Then: these faces are enough for this rank until the next sort; all ranks say so or none.
  void keep_near(const Ground& ground, std::span<const BoundaryFace> faces,
                 std::span<const std::size_t> near);
  /// After a scatter: reads the soil. Ranks exchange it, the sums at the shared nodes, and the kicks, in one
  /// message. Where there is pore water faces become as long as their soil. Positions are all that dry soil
  /// needs of its faces: nothing is read where no ranks share it.
  /// @param kicks  by face (FaceMotion::kicks)
  void read(Ground& ground, std::span<BoundaryFace> faces, std::span<double> kicks);
  /// Where ranks share the domain: all learn the kicks of the faces whose particles others had at the last
  /// sort. All call it.
  void tell_all(const Ground& ground, std::span<double> kicks);
  /// The first rank learns them too, and what was read of wet soil there.
  void tell_first(const Ground& ground, std::span<BoundaryFace> faces, std::span<double> kicks);

  /// The rank that has the particle of each face, if ranks share the domain.
  const SharedList& owners() const { return faces_; }
  /// The soil at each face if there is pore water or if ranks share the domain, of far faces perhaps as of
  /// the last sort; else empty.
  std::span<const FaceSoil> all() const { return soil_; }
  /// Rising; none without ranks.
  std::span<const std::size_t> shared_nodes() const { return nodes_; }

private:
  void read_own(const Ground& ground, std::span<const BoundaryFace> faces);
  void share(Ground& ground, std::span<const BoundaryFace> faces, std::span<double> kicks);
  void take_lengths(const Ground& ground, std::span<BoundaryFace> faces) const;

  /// What this rank exchanges where near faces are enough.
  struct Near {
    Trade faces, sums;
    TradeMessages messages;
  };

  std::vector<FaceSoil> soil_;
  SharedList faces_;
  std::vector<std::size_t> nodes_;
  SharedList sums_; ///< at nodes_; not kept where near faces are enough
  std::optional<Near> near_;
  std::vector<double> numbers_;
};

} // namespace tremolo::mpm_domain
