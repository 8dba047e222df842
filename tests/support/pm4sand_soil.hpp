#pragma once

// The sands of the reference curves of PM4Sand, and their tests.

#include "materials/law/driver.hpp"
#include "tests/support/reference_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace tremolo::materials::test {

inline constexpr double kilopascal = 1e3;

/// Relative density in per cent: 35, 55 or 75, with the stiffness and contraction rates of the report.
inline Pm4Sand report_sand(int density) {
  Pm4SandInput input;
  input.density = 1900.0;
  input.relative_density = 0.01 * density;
  input.G_o = density == 35 ? 476.0 : density == 55 ? 677.0 : 890.0;
  input.h_po = density == 35 ? 0.53 : density == 55 ? 0.40 : 0.63;
  return pm4sand(input);
}

/// The initial stress of a test: sigma'_v, K_0 and a static shear stress, Pa.
inline PointStress geostatic(double sv, double K_0, double tau = 0.0) {
  return {-K_0 * sv, -sv, 0.0, tau};
}

inline double pressure(const PointStress& stress) {
  return -0.5 * (stress.xx + stress.yy);
}

/// A file of the references, by columns; stresses in Pa.
struct Pm4Reference {
  std::vector<double> step, exx, eyy, gxy, sxx, syy, sxy;

  explicit Pm4Reference(const std::string& name) {
    const testing::ReferenceCurve curve(name + ".csv");
    if (curve.empty()) {
      return;
    }
    step = curve.column("step");
    exx = curve.column("eps_xx");
    eyy = curve.column("eps_yy");
    gxy = curve.column("gamma_xy");
    sxx = in_pascal(curve.column("sig_xx"));
    syy = in_pascal(curve.column("sig_yy"));
    sxy = in_pascal(curve.column("sig_xy"));
  }

  bool empty() const { return step.empty(); }
  std::size_t size() const { return step.size(); }
  PointStress stress(std::size_t row) const { return {sxx[row], syy[row], 0.0, sxy[row]}; }

  /// Largest difference of a stress component at a row, Pa.
  double difference(std::size_t row, const PointStress& ours) const {
    return std::max(
        {std::abs(ours.xx - sxx[row]), std::abs(ours.yy - syy[row]), std::abs(ours.xy - sxy[row])});
  }

private:
  static std::vector<double> in_pascal(std::vector<double> values) {
    for (double& value : values) {
      value *= kilopascal;
    }
    return values;
  }
};

/// Follows the strain between two rows in as many equal increments as the reference took.
inline void replay_row(PointTest& point, const Pm4Reference& reference, std::size_t row) {
  const double steps = reference.step[row] - reference.step[row - 1];
  const auto part = [&](const std::vector<double>& strain) {
    return Control::strain((strain[row] - strain[row - 1]) / steps);
  };
  const PointStep step = {part(reference.exx), part(reference.eyy), part(reference.gxy)};
  for (int k = 0; k < static_cast<int>(steps); ++k) {
    point.apply(step);
  }
}

} // namespace tremolo::materials::test
