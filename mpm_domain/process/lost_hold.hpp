#pragma once

#include "mpm_domain/boundary/boundary.hpp"
#include "results/checkpoint_file.hpp"
#include "scene/case.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// How far soil has moved through the dashpots of each face, along the normal, against its free field,
///
///     d = int (v^m - v^ff) . n dt.
///
/// The traction that held the model at rest stays as it was then, and dashpots hold no static force: where
/// soil yields and its weight comes to bear elsewhere, it runs out through them, or away from them.
class LostHold {
public:
  /// @param scene, boundary  outlive this
  LostHold(const scene::Case& scene, const Boundary& boundary);

  /// To be called at the rows of the history, with the velocities of these steps.
  void add(double time, std::span<const Vector> domain, std::span<const eq6::FreeField> free_field);

  /// What a user should know where d has become larger than a cell.
  std::optional<std::string> warning() const;

  void save(results::CheckpointWriter& checkpoint) const;
  void restore(const results::CheckpointReader& checkpoint);

private:
  /// Whether the free field of a face is all of the motion of level ground, and dashpots hold it.
  bool counts(const BoundaryFace& face) const;

  const scene::Case& scene_;
  const Boundary& boundary_;
  std::vector<double> moved_; ///< d of each face, m
  double last_ = 0.0;         ///< s
};

} // namespace tremolo::mpm_domain
