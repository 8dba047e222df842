#include "materials/soiltest/path/root.hpp"

#include <fmt/format.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

namespace tremolo::soiltest {
namespace {

/// The function with a memory, so that nothing is computed twice; and without exceptions, which must not pass
/// through GSL: after one it is zero everywhere, which ends the search.
class Remembered {
public:
  explicit Remembered(const std::function<double(double)>& function) : function_(function) {}

  double operator()(double x) {
    if (failure_)
      return 0.0;
    const auto known = std::find_if(points_.begin(), points_.end(), [&](const Point& p) { return p.x == x; });
    if (known != points_.end())
      return known->value;
    try {
      const double value = function_(x);
      if (!std::isfinite(value))
        throw std::runtime_error(fmt::format("the function is {:g} at {:g}", value, x));
      points_.push_back({x, value});
      return value;
    } catch (...) {
      failure_ = std::current_exception();
      return 0.0;
    }
  }

  void rethrow() const {
    if (failure_)
      std::rethrow_exception(failure_);
  }

  /// The end of a bracket with the smaller value.
  Root better(double low, double high) {
    const double at_low = (*this)(low);
    const double at_high = (*this)(high);
    const bool lower = std::abs(at_low) < std::abs(at_high);
    return {true, lower ? low : high, lower ? at_low : at_high, static_cast<int>(points_.size())};
  }

  /// The point with the smallest value so far.
  Root best(bool found) const {
    const auto best = std::min_element(points_.begin(), points_.end(), [](const Point& a, const Point& b) {
      return std::abs(a.value) < std::abs(b.value);
    });
    return {found, best->x, best->value, static_cast<int>(points_.size())};
  }

private:
  struct Point {
    double x;
    double value;
  };
  const std::function<double(double)>& function_;
  std::vector<Point> points_;
  std::exception_ptr failure_;
};

double call(double x, void* data) {
  return (*static_cast<Remembered*>(data))(x);
}

Root brent(Remembered& function, double low, double high, double tolerance) {
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  if (!solver)
    throw std::bad_alloc();
  gsl_function wrapped = {call, &function};
  gsl_root_fsolver_set(solver.get(), &wrapped, low, high);
  constexpr int most_iterations = 60;
  for (int k = 0; k < most_iterations && high - low > tolerance; ++k) {
    gsl_root_fsolver_iterate(solver.get());
    low = gsl_root_fsolver_x_lower(solver.get());
    high = gsl_root_fsolver_x_upper(solver.get());
  }
  return function.better(low, high);
}

} // namespace

Root find_root(const std::function<double(double)>& function, const RootSearch& search) {
  Remembered remembered(function);
  double x = std::clamp(search.guess, search.least, search.most);
  double value = remembered(x);
  remembered.rethrow();
  Root root = remembered.best(true);
  while (value != 0.0) {
    // Somewhat further than the root that the slope promises, and never a tiny step.
    const double wish = -1.3 * value / search.slope;
    const double step = std::copysign(std::max(std::abs(wish), 10.0 * search.tolerance), wish);
    const double next = std::clamp(x + step, search.least, search.most);
    if (next == x) {
      root = remembered.best(false);
      break;
    }
    const double at_next = remembered(next);
    if (at_next == 0.0 || (at_next > 0.0) != (value > 0.0)) {
      root = brent(remembered, std::min(x, next), std::max(x, next), search.tolerance);
      break;
    }
    x = next;
    value = at_next;
  }
  remembered.rethrow();
  return root;
}

} // namespace tremolo::soiltest
