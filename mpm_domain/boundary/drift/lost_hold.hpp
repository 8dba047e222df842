#pragma once

#include "mpm_domain/boundary/boundary.hpp"
#include "mpm_domain/boundary/springs/ground_springs.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// A face that has moved beyond its free field.
struct FaceDrift {
  Side side = Side::base;
  Vector position; ///< at the start, m
  Vector moved;    ///< d, m
  /// Traction of its spring over the soil's shear strength at rest; 0 without a spring.
  double strength_share = 0.0;
};

/// Drift of the soil at each face relative to its free field,
///
///     d = int (v^m - v^ff) dt.
///
/// The traction that held the model at rest stays as it was then, and dashpots hold no static force: where
/// soil yields and its weight comes to bear elsewhere, springs take it, k d; without springs it runs out
/// through the dashpots, or away from them.
class LostHold {
public:
  /// @param ground      at rest
  /// @param sets        its particles, or as many of them as hold those of all faces
  /// @param boundary    outlives this
  /// @param total_base  whether the free field of the base is all of the motion of level ground
  /// @param far         what is worth a warning, m
  LostHold(const Ground& ground, std::span<const Particles> sets, const Boundary& boundary, bool total_base,
           double far);

  /// Call it at every row of the history, with the velocities of that step.
  void add(double time, std::span<const Vector> ground, std::span<const eq6::FreeField> free_field);

  /// All faces where d counts.
  std::vector<FaceDrift> faces() const;
  /// The largest |d| at each side and the base where it counts, and the fraction of the soil's strength that
  /// k d needs: a sentence, or empty if no side counts.
  std::optional<std::string> report() const;
  /// A warning if the ground beyond a side could not hold the soil: d has become too large along the normal
  /// of a face, or the springs of a side pull beyond the strength of its soil.
  std::optional<std::string> warning() const;

  /// Adds the state that a checkpoint stores.
  void add_state(SavedNumbers& state);

private:
  /// The springs of a face, or null.
  const FaceSprings* springs_at(std::size_t face) const;
  /// Whether d of a face is known, and nothing but dashpots and springs hold it.
  bool counts(std::size_t face) const;
  Vector moved(std::size_t face) const;
  double moved_out(std::size_t face) const;
  /// |k d|, Pa; 0 without a spring.
  double pull(std::size_t face) const;
  /// The pull over the strength at rest.
  double strength_share(std::size_t face) const;
  /// The excess of the pull over the strength at rest, Pa.
  double excess_pull(std::size_t face) const;
  /// The force beyond the strength over the strength, both summed over the side's soils that yield.
  double excess_share(Side side) const;
  /// The face that counts with the largest value, if any does.
  template <class Value>
  std::optional<std::size_t> largest(const Value& value) const;
  std::string position_text(std::size_t face) const;

  const Boundary& boundary_;
  const GroundSprings* springs_; ///< of the boundary; null without any
  bool total_base_;
  double far_;
  std::vector<double> strength_; ///< shear strength of the soil at each face at rest, Pa
  std::vector<Vector> moved_;    ///< d of each face by the rows, where no spring knows it, m
  double last_ = 0.0;            ///< s
};

} // namespace tremolo::mpm_domain
