#include "materials/hysteretic/backbone/curve_fit.hpp"

#include "materials/hysteretic/backbone/backbone.hpp"
#include "materials/hysteretic/backbone/least_squares.hpp"
#include "materials/law/parameter_check.hpp"

#include <cmath>
#include <span>

namespace tremolo::materials {
namespace {

constexpr double least_exponent = 0.1;
constexpr double largest_exponent = 1.0;

/// ln(beta x^s) = intercept + s ln gamma, in which the model is 1/(1 + exp(...)).
struct Line {
  double intercept = 0.0;
  double slope = 1.0;

  double model(double log_strain) const { return 1.0 / (1.0 + std::exp(intercept + slope * log_strain)); }
};

/// The rows to fit, and the slope where it is held.
struct Problem {
  const SoilCurves& curves;
  std::optional<double> held_slope;

  Line line(std::span<const double> p) const { return {p[0], held_slope.value_or(p.back())}; }

  void residuals(std::span<const double> p, std::span<double> r) const {
    const Line fitted = line(p);
    for (std::size_t i = 0; i < r.size(); ++i)
      r[i] = fitted.model(std::log(curves.strain[i])) - curves.modulus_ratio[i];
  }

  /// With m = 1/(1 + e^z): dm/dz = -m (1 - m).
  void jacobian(std::span<const double> p, std::span<double> j) const {
    const Line fitted = line(p);
    for (std::size_t i = 0; i < curves.strain.size(); ++i) {
      const double log_strain = std::log(curves.strain[i]);
      const double m = fitted.model(log_strain);
      j[i * p.size()] = -m * (1.0 - m);
      if (p.size() > 1)
        j[i * p.size() + 1] = -m * (1.0 - m) * log_strain;
    }
  }
};

/// First guess from the point closest to G/Gmax = 1/2, a start away from remote minima.
Line first_guess(const Problem& problem) {
  std::size_t best = 0;
  const auto& ratio = problem.curves.modulus_ratio;
  for (std::size_t i = 1; i < ratio.size(); ++i)
    if (std::abs(ratio[i] - 0.5) < std::abs(ratio[best] - 0.5))
      best = i;
  if (!(ratio[best] < 1.0))
    throw std::invalid_argument("G/Gmax of the soil curve is 1 at all strains: there is no reduction to fit");
  const double slope = problem.held_slope.value_or(0.9);
  return {std::log(1.0 / ratio[best] - 1.0) - slope * std::log(problem.curves.strain[best]), slope};
}

Line fitted_line(const Problem& problem) {
  const Line guess = first_guess(problem);
  const double start[] = {guess.intercept, guess.slope};
  const Minimum minimum = minimise({.rows = problem.curves.strain.size(),
                                    .residuals = [&](auto p, auto r) { problem.residuals(p, r); },
                                    .jacobian = [&](auto p, auto j) { problem.jacobian(p, j); }},
                                   std::span(start).first(problem.held_slope ? 1 : 2));
  if (minimum.ended != Minimum::Ended::converged)
    throw std::runtime_error(fmt::format("the fit of the MKZ backbone did not converge: {}", minimum.reason));
  return problem.line(minimum.unknowns);
}

} // namespace

MkzFit fit_mkz(const SoilCurves& curves, std::optional<double> reference_strain) {
  validate(curves);
  if (reference_strain)
    check_positive("reference_strain", *reference_strain);
  MkzFit fit;
  Line line = fitted_line({curves, std::nullopt});
  if (!(line.slope >= least_exponent && line.slope <= largest_exponent)) {
    line = fitted_line({curves, line.slope > largest_exponent ? largest_exponent : least_exponent});
    fit.exponent_at_limit = true;
  }
  fit.exponent = line.slope;
  fit.reference_strain = reference_strain.value_or(std::exp(-line.intercept / line.slope));
  fit.beta = reference_strain ? std::exp(line.intercept + line.slope * std::log(*reference_strain)) : 1.0;

  double squares = 0.0;
  for (std::size_t i = 0; i < curves.strain.size(); ++i) {
    const double residual = line.model(std::log(curves.strain[i])) - curves.modulus_ratio[i];
    squares += residual * residual;
    if (std::abs(residual) > fit.largest_residual) {
      fit.largest_residual = std::abs(residual);
      fit.strain_of_largest_residual = curves.strain[i];
    }
  }
  fit.rms_residual = std::sqrt(squares / static_cast<double>(curves.strain.size()));
  return fit;
}

std::vector<DampingComparison> masing_against(const SoilCurves& curves, const MkzFit& fit) {
  const Backbone backbone = {1.0, fit.reference_strain, fit.beta, fit.exponent};
  std::vector<DampingComparison> both;
  for (std::size_t i = 0; i < curves.strain.size(); ++i)
    both.push_back({curves.strain[i], curves.damping_ratio[i], masing_damping(backbone, curves.strain[i])});
  return both;
}

} // namespace tremolo::materials
