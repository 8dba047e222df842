#pragma once

#include "freefield/column.hpp"
#include "freefield/fe/column_mesh.hpp"
#include "freefield/fe/fe_linear.hpp"
#include "freefield/fe/fe_nonlinear.hpp"
#include "freefield/fe/fe_settings.hpp"
#include "freefield/profile.hpp"

#include <variant>

namespace tremolo::freefield {

/// Finite-element column with two degrees of freedom a node, horizontal and vertical displacement. Laterally
/// periodic: all fields depend on y and t alone. Without laws in its profile it is linear and takes the fast
/// path, a constant factored matrix for each component.
class FeColumn final : public Column {
public:
  /// @throws std::invalid_argument for values outside their range, for an explicit time step over the
  ///         stability limit (the message states the limit), and for a geostatic stress beyond the strength
  FeColumn(const Profile& profile, const FeColumnSettings& settings, InputVelocity input);

  /// @throws std::runtime_error also if Newton's method does not converge (fe_nonlinear.hpp)
  void step() override;
  double time() const override;
  double time_step() const override { return settings_.time_step; }
  double base_level() const override { return mesh_.node_y.front(); }
  double surface_level() const override { return mesh_.node_y.back(); }
  void sample(std::span<const double> y, std::span<ColumnSample> samples) const override;

  /// Energy of both components since the start, J per m2 of plan area.
  ColumnEnergy energy() const;

  /// Work of Newton's method; none in a linear column.
  NewtonCounts counts() const;
  std::string report() const override;

private:
  FeColumnSettings settings_;
  ColumnMesh mesh_;
  InputVelocity input_;
  std::variant<LinearColumn, NonlinearColumn> soil_;
  long steps_ = 0;
};

/// The largest stable step of central differences for this profile at small strain, s.
double central_difference_limit(const Profile& profile, double max_element_size, const Damping& damping);

} // namespace tremolo::freefield
