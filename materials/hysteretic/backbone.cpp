// Damping of the symmetric Masing loop. With F the backbone, g the amplitude and X = beta (g/gamma_r)^s,
//
//     xi = 4 [int_0^g F(u) du - g F(g)/2] / (pi g F(g)) = (4/pi) X int_0^1 t (1 - t^s) / (1 + X t^s) dt:
//
// the second form has no difference of nearly equal numbers. For s = 1 it is, closed and as a power series,
//
//     xi = (4/pi) (1 + 1/X) [1 - ln(1 + X)/X] - 2/pi = (4/pi) sum_k (-1)^(k+1) X^k / ((k+1)(k+2)).

#include "materials/hysteretic/backbone.hpp"

#include "materials/law/parameter_check.hpp"

#include <gsl/gsl_integration.h>

#include <limits>
#include <memory>
#include <new>
#include <numbers>

namespace tremolo::materials {
namespace {

double hyperbolic_damping(double x) {
  constexpr double pi = std::numbers::pi;
  if (x > 0.05)
    return 4.0 / pi * (1.0 + 1.0 / x) * (1.0 - std::log1p(x) / x) - 2.0 / pi;
  double sum = 0.0;
  double power = x;
  for (int k = 1; k <= 12; ++k) { // 0.05^13 = 1e-17
    sum += power / ((k + 1) * (k + 2));
    power *= -x;
  }
  return 4.0 / pi * sum;
}

/// X and s of the integrand.
struct LoopShape {
  double reduction;
  double exponent;
};

/// The integrand with t = w^(2/s): smooth at w = 0, where t^s is not.
double loop_integrand(double w, void* shape) {
  const auto& [reduction, exponent] = *static_cast<const LoopShape*>(shape);
  const double power = w * w;
  return 2.0 / exponent * std::pow(w, 4.0 / exponent - 1.0) * (1.0 - power) / (1.0 + reduction * power);
}

double mkz_damping(LoopShape shape) {
  constexpr std::size_t points = 256;
  const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> table(
      gsl_integration_glfixed_table_alloc(points), gsl_integration_glfixed_table_free);
  if (!table)
    throw std::bad_alloc();
  gsl_function integrand{loop_integrand, &shape};
  return 4.0 / std::numbers::pi * shape.reduction *
         gsl_integration_glfixed(&integrand, 0.0, 1.0, table.get());
}

} // namespace

double Backbone::strength() const {
  return exponent == 1.0 ? shear_modulus * reference_strain / beta : std::numeric_limits<double>::infinity();
}

void validate(const Backbone& backbone) {
  check_positive("shear modulus of the backbone", backbone.shear_modulus);
  check_positive("reference_strain", backbone.reference_strain);
  check_positive("beta", backbone.beta);
  check_range("exponent", backbone.exponent, 0.1, 1.0); // above 1 the stress would fall with growing strain
}

double masing_damping(const Backbone& backbone, double strain) {
  const double reduction = backbone.reduction(strain);
  return backbone.exponent == 1.0 ? hyperbolic_damping(reduction)
                                  : mkz_damping({reduction, backbone.exponent});
}

} // namespace tremolo::materials
