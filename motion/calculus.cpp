#include "motion/gsl_calls.hpp"
#include "motion/record.hpp"

#include <gsl/gsl_spline.h>

namespace tremolo::motion {

std::vector<double> integrate(std::span<const double> samples, double dt) {
  std::vector<double> integral(samples.size(), 0.0);
  for (std::size_t i = 1; i < samples.size(); ++i)
    integral[i] = integral[i - 1] + 0.5 * dt * (samples[i - 1] + samples[i]);
  return integral;
}

std::vector<double> differentiate(std::span<const double> samples, double dt) {
  if (samples.size() < 2)
    throw std::invalid_argument("a slope needs at least 2 samples");
  if (samples.size() == 2)
    return std::vector<double>(2, (samples[1] - samples[0]) / dt);
  // The abscissae are in units of dt, in which they are exact.
  std::vector<double> steps(samples.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
    steps[i] = static_cast<double>(i);
  const auto spline = owned(gsl_spline_alloc, gsl_spline_free, gsl_interp_cspline, samples.size());
  const auto place = owned(gsl_interp_accel_alloc, gsl_interp_accel_free);
  check(gsl_spline_init(spline.get(), steps.data(), samples.data(), samples.size()));
  std::vector<double> slope(samples.size());
  for (std::size_t i = 0; i < slope.size(); ++i)
    slope[i] = gsl_spline_eval_deriv(spline.get(), steps[i], place.get()) / dt;
  return slope;
}

} // namespace tremolo::motion
