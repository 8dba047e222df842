#pragma once

#include "freefield/fe/column_mesh.hpp"
#include "freefield/fe/fe_settings.hpp"
#include "freefield/fe/scalar_column.hpp"

#include <vector>

namespace tremolo::freefield {

/// A column of linear soil: shear (vx, sxy) and dilation (vy, syy, sxx = lambda/M syy) are two columns of
/// scalar waves that share a mesh.
class LinearColumn {
public:
  /// @throws std::invalid_argument for an explicit step over the stability limit
  LinearColumn(const Profile& profile, const ColumnMesh& mesh, const FeColumnSettings& settings);

  /// Advances by the settings' time step from `time`.
  /// @throws std::runtime_error if the motion is no longer finite
  void step(const InputVelocity& input, double time);

  ColumnSample sample(const ColumnMesh::Place& place) const;
  ColumnEnergy energy() const;
  NewtonCounts counts() const { return {}; }

private:
  ColumnMesh mesh_;
  BaseKind base_kind_;
  Rise rise_;
  double dt_;
  std::vector<double> lateral_ratio_; ///< lambda/M, one an element
  ScalarColumn shear_;
  ScalarColumn dilation_;
  BaseMotion base_;
};

/// The largest stable step of central differences for this profile at small strain, s.
double central_difference_limit(const Profile& profile, const ColumnMesh& mesh, const Damping& damping);

} // namespace tremolo::freefield
