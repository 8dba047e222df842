// Stress-strain loops as CSV: `model,strain,stress_pa` of one irregular path by the exact rules (masing) and
// by parallel elements (iwan), then `curve,strain,modulus_ratio,damping_ratio` of Darendeli's curves and of
// the backbone fitted to them. draw_loops.py makes the picture.

#include "materials/hysteretic/backbone/curve_fit.hpp"
#include "materials/law/driver.hpp"

#include <cstdio>
#include <initializer_list>

using namespace tremolo::materials;

namespace {

void print_path(const char* model, const Law& law) {
  PointTest point(law, {});
  for (const double turn : {2e-3, -1e-3, 1e-3, 2e-4, 6e-4, -3e-3, 3e-3, -3e-3, 4e-3}) {
    constexpr int steps = 100;
    const double change = (turn - point.strain().xy) / steps;
    for (int k = 0; k < steps; ++k) {
      point.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(change)});
      std::printf("%s,%.8g,%.8g\n", model, point.strain().xy, point.stress().xy);
    }
  }
}

} // namespace

int main() {
  const SoilCurves curves = darendeli_curves({.plasticity_index = 15.0, .mean_effective_stress = 101325.0});
  const MkzFit fit = fit_mkz(curves);
  const Elasticity elastic = Elasticity::from_wave_speeds(1900.0, 200.0, 400.0);
  std::puts("model,strain,stress_pa");
  print_path("masing", MasingShear{elastic, fit.reference_strain, fit.beta, fit.exponent});
  print_path("iwan", iwan_shear(elastic, fit.reference_strain, fit.beta, fit.exponent));
  const Backbone backbone = {1.0, fit.reference_strain, fit.beta, fit.exponent};
  std::puts("curve,strain,modulus_ratio,damping_ratio");
  for (const DampingComparison& row : masing_against(curves, fit)) {
    std::printf("darendeli,%.8g,%.8g,%.8g\n", row.strain, curves.modulus_ratio_at(row.strain), row.curve);
    std::printf("mkz,%.8g,%.8g,%.8g\n", row.strain, backbone.secant(row.strain), row.masing);
  }
}
