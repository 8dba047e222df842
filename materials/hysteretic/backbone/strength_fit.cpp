// The unknowns of the least squares are ln(limit - theta1), ln theta3 and the logit of (theta1 +
// theta2)/limit, which have no bounds. The sum has several minima: the best of a few starts is taken.

#include "materials/hysteretic/backbone/strength_fit.hpp"

#include "materials/hysteretic/backbone/least_squares.hpp"
#include "materials/law/parameter_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace tremolo::materials {
namespace {

constexpr std::size_t unknowns = 3;
constexpr double limit = 0.999; ///< of theta

using Unknowns = std::array<double, unknowns>;

QuadraticShape shape_of(std::span<const double> p) {
  const auto bounded = [&](std::size_t i) { return std::exp(std::clamp(p[i], -12.0, 10.0)); };
  const double first = limit - bounded(0);
  const double last = limit / (1.0 + bounded(1));
  return {first, last - first, bounded(2), 1.0, 0.99};
}

struct Problem {
  const SoilCurves& curves;
  std::size_t rows; ///< the first of the curve, which are fitted
  double reference_strain;

  void residuals(std::span<const double> p, std::span<double> f) const {
    const QuadraticShape shape = shape_of(p);
    for (std::size_t i = 0; i < rows; ++i) {
      const double r = shape.reduction(curves.strain[i] / reference_strain).value;
      f[i] = 1.0 / (1.0 + r) - curves.modulus_ratio[i];
    }
  }
};

/// A shape at a minimum, and the sum of squares there.
struct Fit {
  QuadraticShape shape;
  double squares;
};

std::optional<Fit> fit_from(const Unknowns& start, const Problem& problem) {
  const Minimum minimum = minimise({.rows = problem.rows,
                                    .residuals = [&](auto p, auto r) { problem.residuals(p, r); },
                                    .tolerance = 1e-10,
                                    .most_iterations = 300},
                                   start);
  if (minimum.ended == Minimum::Ended::failed)
    return std::nullopt;
  const QuadraticShape shape = shape_of(minimum.unknowns);
  try {
    validate(shape);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
  return Fit{shape, minimum.squares};
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
  std::optional<Fit> best;
  for (const double first : {0.0, 1.5, 3.0})
    for (const double last : {-3.0, 0.0, 3.0})
      for (const double third : {-1.0, 1.0, 3.0}) {
        const auto found = fit_from({first, last, third}, {curves, rows, reference_strain});
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
