#pragma once

#include "freefield/column.hpp"
#include "freefield/profile.hpp"

#include <memory>
#include <vector>

namespace tremolo::freefield {

class OdePolarisation;

/// Time integrator of the column's ordinary differential equations (SUNDIALS).
enum class OdeMethod {
  adams, ///< CVODE, Adams-Moulton of order 1 to 12 with functional iteration: not stiff
  bdf,   ///< CVODE, backward differentiation of order 1 to 5, Newton with banded matrices: stiff
  explicit_runge_kutta, ///< ARKODE, explicit, order 3 or 5 by tolerance: not stiff
  imex ///< ARKODE, additive Runge-Kutta, order 3 or 4: stiffness-proportional damping implicit
};

struct OdeColumnSettings {
  double max_cell_size = 0.0; ///< m; every layer is cut into equal cells no longer than this
  double time_step = 0.0;     ///< s; the interval that step() serves, without any effect on the steps inside
  OdeMethod method = OdeMethod::explicit_runge_kutta;
  double relative_tolerance = 1e-4; ///< of the local error of a step, in (0, 0.1]
  double absolute_tolerance = 1e-6; ///< of particle velocity, m/s; that of strain is this over the wave speed
  Damping damping;                  ///< read only where a layer has a damping ratio
  double start_time = 0.0;          ///< s; the column is at rest then
  BaseKind base = BaseKind::compliant;
  /// Longest step inside, s: a tenth of the shortest period of the motion. A column at rest would otherwise
  /// lengthen its steps until one of them stepped over the beginning of a pulse.
  double max_step = 0.01;
};

/// Statistics of the integrator so far, both polarisations together.
struct OdeStatistics {
  long steps = 0;                ///< accepted
  long rejections = 0;           ///< steps that failed the error test
  long convergence_failures = 0; ///< steps whose implicit equations did not converge
  long right_hand_sides = 0;     ///< evaluations; of the explicit part for imex
  long implicit_sides = 0;       ///< of the implicit part, imex only
  long jacobians = 0;            ///< evaluations of the Jacobian matrix
};

/// Method of lines: a column with velocity and strain staggered in depth, second order, whose equations an
/// adaptive integrator marches with error control. Dense output serves any time, so the integrator never
/// stops for one. Shear (vx, sxy) and dilation (vy, syy, sxx = lambda/M syy) are two systems with steps of
/// their own. Layers are linear elastic or follow a backbone with Masing rules in shear.
class OdeColumn final : public Column {
public:
  /// @throws std::invalid_argument for values outside their range, and for a layer whose law is neither
  ///         linear elastic nor of Masing type (the model `fe` takes any)
  OdeColumn(const Profile& profile, const OdeColumnSettings& settings, InputVelocity input);
  ~OdeColumn() override;

  /// @throws std::runtime_error with time and level where the integrator gave up
  void step() override;
  double time() const override;
  double time_step() const override { return settings_.time_step; }
  double base_level() const override;
  double surface_level() const override;
  void sample(std::span<const double> y, std::span<ColumnSample> samples) const override;

  OdeStatistics statistics() const;
  std::string report() const override;

private:
  OdeColumnSettings settings_;
  std::unique_ptr<OdePolarisation> shear_;
  std::unique_ptr<OdePolarisation> dilation_;
  std::vector<double> lateral_ratio_; ///< lambda/M, one a layer
  long steps_ = 0;
};

} // namespace tremolo::freefield
