// Damping of the symmetric Masing loop. With F the backbone, g the amplitude and X = beta (g/gamma_r)^s,
//
//     xi = 4 [int_0^g F(u) du - g F(g)/2] / (pi g F(g)) = (4/pi) X int_0^1 t (1 - t^s) / (1 + X t^s) dt:
//
// the second form has no difference of nearly equal numbers. For s = 1 it is, closed and as a power series,
//
//     xi = (4/pi) (1 + 1/X) [1 - ln(1 + X)/X] - 2/pi = (4/pi) sum_k (-1)^(k+1) X^k / ((k+1)(k+2)).
//
// With the reduction r(gamma) of any other backbone it is
//
//     xi = (4/pi) int_0^1 t [r(g) - r(g t)] / [1 + r(g t)] dt.

#include "materials/hysteretic/backbone/backbone.hpp"

#include "materials/law/parameter_check.hpp"

#include <gsl/gsl_integration.h>

#include <array>
#include <limits>
#include <memory>
#include <new>
#include <numbers>

namespace tremolo::materials {
namespace {

constexpr std::string_view of_curve = "fitted to `curve`";
constexpr std::array given = {Parameter{.name = "reference_strain",
                                        .unit = "1",
                                        .meaning = "engineering shear strain gamma_r of the backbone",
                                        .range = above_zero,
                                        .otherwise = of_curve},
                              Parameter{.name = "beta",
                                        .unit = "1",
                                        .meaning = "factor beta of the backbone",
                                        .range = above_zero,
                                        .otherwise = of_curve},
                              // above 1 the stress would fall with growing strain
                              Parameter{.name = "exponent",
                                        .unit = "1",
                                        .meaning = "exponent s of the backbone",
                                        .range = {.low = 0.1, .high = 1.0},
                                        .otherwise = of_curve,
                                        .remark = "1 is the hyperbola."},
                              Parameter{.name = "shear_strength",
                                        .unit = "Pa",
                                        .meaning = "largest dynamic shear stress",
                                        .range = above_zero,
                                        .otherwise = "not known"}};

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

/// int_0^1 of a function with `data`.
double integral(double (*function)(double, void*), void* data) {
  constexpr std::size_t points = 256;
  const std::unique_ptr<gsl_integration_glfixed_table, decltype(&gsl_integration_glfixed_table_free)> table(
      gsl_integration_glfixed_table_alloc(points), gsl_integration_glfixed_table_free);
  if (!table)
    throw std::bad_alloc();
  gsl_function integrand{function, data};
  return gsl_integration_glfixed(&integrand, 0.0, 1.0, table.get());
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
  return 4.0 / std::numbers::pi * shape.reduction * integral(loop_integrand, &shape);
}

/// A loop of any backbone.
struct AnyLoop {
  const Backbone& backbone;
  double amplitude;
  double reduction;
};

/// The integrand with t = w^4: the strength is reached within a small share of a large amplitude.
double any_loop_integrand(double w, void* data) {
  const auto& [backbone, amplitude, reduction] = *static_cast<const AnyLoop*>(data);
  const double t = w * w * w * w;
  const double here = backbone.reduction(amplitude * t);
  return 4.0 * w * w * w * t * (reduction - here) / (1.0 + here);
}

double any_damping(const Backbone& backbone, double strain) {
  AnyLoop loop{backbone, strain, backbone.reduction(strain)};
  return 4.0 / std::numbers::pi * integral(any_loop_integrand, &loop);
}

} // namespace

double Backbone::strength() const {
  return shape || exponent == 1.0 ? shear_modulus * reference_strain / beta
                                  : std::numeric_limits<double>::infinity();
}

std::span<const Parameter> backbone_parameters() {
  return given;
}

void validate(const Backbone& backbone) {
  check_positive("shear modulus of the backbone", backbone.shear_modulus);
  check(given[0], backbone.reference_strain);
  check(given[1], backbone.beta);
  check(given[2], backbone.exponent);
  if (backbone.shape)
    validate(*backbone.shape);
  validate(backbone.loops);
}

void validate(const QuadraticShape& shape) {
  constexpr double most = 0.999; // at 1 the stress has a corner at the strength
  constexpr double least = -1e6;
  check_range("theta1", shape.first, least, most);
  check_range("theta1 + theta2", shape.first + shape.second, least, most);
  check_range("theta3", shape.third, 1e-6, 1e6);
  check_range("theta4", shape.fourth, 1e-6, 1e6);
  check_range("theta5", shape.fifth, 0.1, 3.0);
  for (double x = 1e-4; x < 1e4; x *= 1.05) {
    const auto [value, slope] = shape.reduction(x);
    if (!(1.0 + value - slope > 0.0))
      throw std::invalid_argument(
          fmt::format("theta1 to theta5 of the backbone: the stress falls with growing strain at {:g} times "
                      "the strain strength/G0",
                      x));
    if (!(slope >= 0.0))
      throw std::invalid_argument(
          fmt::format("theta1 to theta5 of the backbone: the secant modulus grows with the strain at {:g} "
                      "times the strain strength/G0",
                      x));
  }
}

double masing_damping(const Backbone& backbone, double strain) {
  if (backbone.shape)
    return any_damping(backbone, strain);
  const double reduction = backbone.reduction(strain);
  return backbone.exponent == 1.0 ? hyperbolic_damping(reduction)
                                  : mkz_damping({reduction, backbone.exponent});
}

double loop_damping(const Backbone& backbone, double strain) {
  return backbone.loops.factor(backbone.reduction(strain)) * masing_damping(backbone, strain);
}

} // namespace tremolo::materials
