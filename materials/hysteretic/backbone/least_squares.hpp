#pragma once

// The unknowns p that minimise the sum of squares of residuals r(p), by GSL's trust region method
// (Levenberg-Marquardt).

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::materials {

struct LeastSquares {
  using Function = std::function<void(std::span<const double> unknowns, std::span<double> values)>;

  std::size_t rows = 0;
  Function residuals;       ///< writes r
  Function jacobian{};      ///< writes dr_i/dp_j at i times the number of unknowns + j; none: by differences
  double tolerance = 1e-12; ///< relative, of the step and of the gradient
  std::size_t most_iterations = 200;
};

struct Minimum {
  enum class Ended { converged, out_of_iterations, failed };

  std::vector<double> unknowns;
  double squares = 0.0; ///< the sum there
  Ended ended = Ended::failed;
  std::string reason; ///< GSL's word for it
};

/// @throws std::bad_alloc
Minimum minimise(const LeastSquares& problem, std::span<const double> start);

} // namespace tremolo::materials
