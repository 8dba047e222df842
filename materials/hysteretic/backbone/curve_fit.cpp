#include "materials/hysteretic/backbone/curve_fit.hpp"

#include "materials/hysteretic/backbone/backbone.hpp"
#include "materials/law/parameter_check.hpp"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <cmath>
#include <memory>
#include <new>

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

  Line line(const gsl_vector* p) const {
    return {gsl_vector_get(p, 0), held_slope ? *held_slope : gsl_vector_get(p, 1)};
  }
};

int residuals(const gsl_vector* p, void* data, gsl_vector* f) {
  const Problem& problem = *static_cast<const Problem*>(data);
  const Line line = problem.line(p);
  for (std::size_t i = 0; i < f->size; ++i)
    gsl_vector_set(f, i, line.model(std::log(problem.curves.strain[i])) - problem.curves.modulus_ratio[i]);
  return GSL_SUCCESS;
}

/// With m = 1/(1 + e^z): dm/dz = -m (1 - m).
int jacobian(const gsl_vector* p, void* data, gsl_matrix* j) {
  const Problem& problem = *static_cast<const Problem*>(data);
  const Line line = problem.line(p);
  for (std::size_t i = 0; i < j->size1; ++i) {
    const double log_strain = std::log(problem.curves.strain[i]);
    const double m = line.model(log_strain);
    gsl_matrix_set(j, i, 0, -m * (1.0 - m));
    if (j->size2 > 1)
      gsl_matrix_set(j, i, 1, -m * (1.0 - m) * log_strain);
  }
  return GSL_SUCCESS;
}

/// Where the curve passes closest to G/Gmax = 1/2, a start that no far-off minimum is near.
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

Line least_squares(Problem problem) {
  const std::size_t unknowns = problem.held_slope ? 1 : 2;
  const std::size_t rows = problem.curves.strain.size();
  const Line guess = first_guess(problem);
  const double start[] = {guess.intercept, guess.slope};
  const gsl_vector_const_view begin = gsl_vector_const_view_array(start, unknowns);
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  const std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)> workspace(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, rows, unknowns),
      gsl_multifit_nlinear_free);
  if (!workspace)
    throw std::bad_alloc();
  gsl_multifit_nlinear_fdf functions{};
  functions.f = residuals;
  functions.df = jacobian;
  functions.n = rows;
  functions.p = unknowns;
  functions.params = &problem;
  gsl_multifit_nlinear_init(&begin.vector, &functions, workspace.get());
  int reason = 0;
  const int status =
      gsl_multifit_nlinear_driver(200, 1e-12, 1e-12, 0.0, nullptr, nullptr, &reason, workspace.get());
  // GSL_ENOPROG: no step lowers the sum any more, which at the minimum is what rounding leaves.
  if (status != GSL_SUCCESS && status != GSL_ENOPROG) {
    throw std::runtime_error(
        fmt::format("the fit of the MKZ backbone did not converge: {}", gsl_strerror(status)));
  }
  return problem.line(gsl_multifit_nlinear_position(workspace.get()));
}

} // namespace

MkzFit fit_mkz(const SoilCurves& curves, std::optional<double> reference_strain) {
  validate(curves);
  if (reference_strain)
    check_positive("reference_strain", *reference_strain);
  MkzFit fit;
  Line line = least_squares({curves, std::nullopt});
  if (!(line.slope >= least_exponent && line.slope <= largest_exponent)) {
    line = least_squares({curves, line.slope > largest_exponent ? largest_exponent : least_exponent});
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
