// The unknowns of the least squares are ln(limit - theta1), ln theta3 and the logit of (theta1 +
// theta2)/limit, which have no bounds. The sum has several minima: the best of a few starts is taken.

#include "materials/hysteretic/backbone/strength_fit.hpp"

#include "materials/law/parameter_check.hpp"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <new>
#include <optional>

namespace tremolo::materials {
namespace {

constexpr std::size_t unknowns = 3;
constexpr double limit = 0.999; ///< of theta

using Unknowns = std::array<double, unknowns>;

QuadraticShape shape_of(const gsl_vector* p) {
  const auto bounded = [&](std::size_t i) { return std::exp(std::clamp(gsl_vector_get(p, i), -12.0, 10.0)); };
  const double first = limit - bounded(0);
  const double last = limit / (1.0 + bounded(1));
  return {first, last - first, bounded(2), 1.0, 0.99};
}

struct Problem {
  const SoilCurves& curves;
  std::size_t rows; ///< the first of the curve, which are fitted
  double reference_strain;
};

int residuals(const gsl_vector* p, void* data, gsl_vector* f) {
  const auto& [curves, rows, reference_strain] = *static_cast<const Problem*>(data);
  const QuadraticShape shape = shape_of(p);
  for (std::size_t i = 0; i < rows; ++i) {
    const double r = shape.reduction(curves.strain[i] / reference_strain).value;
    gsl_vector_set(f, i, 1.0 / (1.0 + r) - curves.modulus_ratio[i]);
  }
  return GSL_SUCCESS;
}

/// A minimum, and the sum of squares there.
struct Minimum {
  QuadraticShape shape;
  double squares;
};

std::optional<Minimum> minimum_from(const Unknowns& start, Problem problem) {
  const gsl_vector_const_view begin = gsl_vector_const_view_array(start.data(), unknowns);
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  const std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)> workspace(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, problem.rows, unknowns),
      gsl_multifit_nlinear_free);
  if (!workspace)
    throw std::bad_alloc();
  gsl_multifit_nlinear_fdf functions{};
  functions.f = residuals; // without a Jacobian it is taken from differences
  functions.n = problem.rows;
  functions.p = unknowns;
  functions.params = &problem;
  gsl_multifit_nlinear_init(&begin.vector, &functions, workspace.get());
  int reason = 0;
  const int status =
      gsl_multifit_nlinear_driver(300, 1e-10, 1e-10, 0.0, nullptr, nullptr, &reason, workspace.get());
  if (status != GSL_SUCCESS && status != GSL_ENOPROG && status != GSL_EMAXITER)
    return std::nullopt;
  const QuadraticShape shape = shape_of(gsl_multifit_nlinear_position(workspace.get()));
  try {
    validate(shape);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
  double squares = 0.0;
  gsl_blas_ddot(gsl_multifit_nlinear_residual(workspace.get()),
                gsl_multifit_nlinear_residual(workspace.get()), &squares);
  return Minimum{shape, squares};
}

} // namespace

QuadraticShape fit_quadratic_shape(const SoilCurves& curves, double reference_strain) {
  validate(curves);
  check_positive("strength over G0", reference_strain);
  const std::size_t rows = static_cast<std::size_t>(
      std::ranges::upper_bound(curves.strain, largest_fitted_strain * (1.0 + 1e-9)) - curves.strain.begin());
  if (rows < unknowns)
    throw std::invalid_argument(
        fmt::format("the soil curve has {} rows up to a strain of {:g}: a backbone with a "
                    "strength is fitted to {} or more",
                    rows, largest_fitted_strain, unknowns));
  std::optional<Minimum> best;
  for (const double first : {0.0, 1.5, 3.0})
    for (const double last : {-3.0, 0.0, 3.0})
      for (const double third : {-1.0, 1.0, 3.0}) {
        const auto found = minimum_from({first, last, third}, {curves, rows, reference_strain});
        if (found && (!best || found->squares < best->squares))
          best = found;
      }
  if (!best)
    throw std::runtime_error(
        "no backbone with this strength follows the soil curve: its stress would fall with "
        "growing strain");
  return best->shape;
}

} // namespace tremolo::materials
