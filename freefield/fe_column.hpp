#pragma once

#include "freefield/column.hpp"
#include "freefield/column_mesh.hpp"
#include "freefield/profile.hpp"
#include "freefield/scalar_column.hpp"

#include <vector>

namespace tremolo::freefield {

/// The stiffness that Newton's method takes in a column with nonlinear layers.
enum class Tangent {
  consistent, ///< of the law's own update at the present iterate: few iterations
  initial     ///< at small strain (modified Newton), factored once: many cheap iterations
};

struct FeColumnSettings {
  double max_element_size = 0.0; ///< m; every layer is cut into equal elements no longer than this
  double time_step = 0.0;        ///< s
  Integrator integrator = Integrator::newmark;
  Damping damping;         ///< read only where a layer has a damping ratio
  double start_time = 0.0; ///< s; the column is at rest then
  BaseKind base = BaseKind::compliant;
  double hht_alpha = 0.0;                ///< of Newmark: Hilber, Hughes and Taylor's, in [-1/3, 0]
  Tangent tangent = Tangent::consistent; ///< read only with nonlinear layers and Newmark
  double newton_tolerance = 1e-8;        ///< largest force residual over the largest traction so far
};

/// Finite-element column with two degrees of freedom a node, horizontal and vertical displacement. Laterally
/// periodic: all fields depend on y and t alone, so shear (vx, sxy) and dilation (vy, syy, sxx = lambda/M
/// syy) are two columns of scalar waves that share a mesh.
class FeColumn final : public Column {
public:
  /// @throws std::invalid_argument for values outside their range, and for an explicit time step over the
  /// stability
  ///         limit (the message states the limit)
  FeColumn(const Profile& profile, const FeColumnSettings& settings, InputVelocity input);

  void step() override;
  double time() const override;
  double time_step() const override { return settings_.time_step; }
  double base_level() const override { return mesh_.node_y.front(); }
  double surface_level() const override { return mesh_.node_y.back(); }
  void sample(std::span<const double> y, std::span<ColumnSample> samples) const override;

  /// Energy of both polarisations since the start, J per m2 of plan area.
  ColumnEnergy energy() const;

private:
  FeColumnSettings settings_;
  ColumnMesh mesh_;
  std::vector<double> lateral_ratio_; ///< lambda/M, one an element
  InputVelocity input_;
  ScalarColumn shear_;
  ScalarColumn dilation_;
  long steps_ = 0;
};

/// The largest stable step of central differences for this profile, s.
double central_difference_limit(const Profile& profile, double max_element_size, const Damping& damping);

} // namespace tremolo::freefield
