#pragma once

#include "mpm_domain/boundary/boundary.hpp"

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
  /// @param boundary    outlives this
  /// @param total_base  whether the free field of the base is all of the motion of level ground
  /// @param far         what is worth telling, m
  LostHold(const Boundary& boundary, bool total_base, double far);

  /// To be called at the rows of the history, with the velocities of these steps.
  void add(double time, std::span<const Vector> ground, std::span<const eq6::FreeField> free_field);

  /// What a user should know where d has become larger than that.
  std::optional<std::string> warning() const;

  /// For a checkpoint.
  std::vector<double> state() const;
  void set_state(std::vector<double> state);

private:
  /// Whether the free field of a face is all of the motion of level ground, and dashpots hold it.
  bool counts(const BoundaryFace& face) const;

  const Boundary& boundary_;
  bool total_base_;
  double far_;
  std::vector<double> moved_; ///< d of each face, m
  double last_ = 0.0;         ///< s
};

} // namespace tremolo::mpm_domain
