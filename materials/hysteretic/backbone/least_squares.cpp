#include "materials/hysteretic/backbone/least_squares.hpp"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <memory>
#include <new>

namespace tremolo::materials {
namespace {

/// The values of GSL's own vector of unknowns, which has no stride.
std::span<const double> values_of(const gsl_vector* v) {
  return {v->data, v->size};
}

int residuals(const gsl_vector* p, void* data, gsl_vector* f) {
  std::vector<double> values(f->size); // differences are taken in columns of a matrix, with a stride
  static_cast<const LeastSquares*>(data)->residuals(values_of(p), values);
  for (std::size_t i = 0; i < values.size(); ++i)
    gsl_vector_set(f, i, values[i]);
  return GSL_SUCCESS;
}

int jacobian(const gsl_vector* p, void* data, gsl_matrix* j) {
  static_cast<const LeastSquares*>(data)->jacobian(values_of(p), {j->data, j->size1 * j->size2});
  return GSL_SUCCESS;
}

Minimum::Ended ended(int status) {
  // GSL_ENOPROG: no step lowers the sum any more, which at the minimum is what rounding leaves.
  if (status == GSL_SUCCESS || status == GSL_ENOPROG)
    return Minimum::Ended::converged;
  return status == GSL_EMAXITER ? Minimum::Ended::out_of_iterations : Minimum::Ended::failed;
}

} // namespace

Minimum minimise(const LeastSquares& problem, std::span<const double> start) {
  const gsl_vector_const_view begin = gsl_vector_const_view_array(start.data(), start.size());
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  const std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)> workspace(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, problem.rows, start.size()),
      gsl_multifit_nlinear_free);
  if (!workspace)
    throw std::bad_alloc();
  LeastSquares own = problem; // GSL wants it without const
  gsl_multifit_nlinear_fdf functions{};
  functions.f = residuals;
  functions.df = problem.jacobian ? jacobian : nullptr;
  functions.n = problem.rows;
  functions.p = start.size();
  functions.params = &own;
  gsl_multifit_nlinear_init(&begin.vector, &functions, workspace.get());
  int reason = 0;
  const int status =
      gsl_multifit_nlinear_driver(problem.most_iterations, problem.tolerance, problem.tolerance, 0.0, nullptr,
                                  nullptr, &reason, workspace.get());
  const std::span<const double> found = values_of(gsl_multifit_nlinear_position(workspace.get()));
  Minimum minimum{{found.begin(), found.end()}, 0.0, ended(status), gsl_strerror(status)};
  const gsl_vector* rest = gsl_multifit_nlinear_residual(workspace.get());
  gsl_blas_ddot(rest, rest, &minimum.squares);
  return minimum;
}

} // namespace tremolo::materials
