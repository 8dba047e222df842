#include "materials/soiltest/root.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <vector>

namespace tremolo::soiltest {
namespace {

/// The function with a memory, so that nothing is computed twice; and without exceptions, which must not pass
/// through GSL: after one it is zero everywhere, which ends the search.
class Remembered {
public:
  explicit Remembered(const std::function<double(double)>& function) : function_(function) {}

  double operator()(double x) {
    if (failure_) {
      return 0.0;
    }
    const auto known = std::find_if(points_.begin(), points_.end(), [&](const Point& p) { return p.x == x; });
    if (known != points_.end()) {
      return known->value;
    }
    try {
      points_.push_back({x, function_(x)});
      return points_.back().value;
    } catch (...) {
      failure_ = std::current_exception();
      return 0.0;
    }
  }

  void rethrow() const {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
  }

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

void brent(Remembered& function, double low, double high, double tolerance) {
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  if (!solver) {
    throw std::bad_alloc();
  }
  gsl_function wrapped = {call, &function};
  gsl_root_fsolver_set(solver.get(), &wrapped, low, high);
  constexpr int most_iterations = 60;
  for (int k = 0; k < most_iterations; ++k) {
    gsl_root_fsolver_iterate(solver.get());
    if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()), gsl_root_fsolver_x_upper(solver.get()),
                               tolerance, 0.0) == GSL_SUCCESS) {
      return;
    }
  }
}

} // namespace

Root find_root(const std::function<double(double)>& function, const RootSearch& search) {
  Remembered remembered(function);
  double x = std::clamp(search.guess, search.least, search.most);
  double value = remembered(x);
  while (value != 0.0) {
    // Somewhat further than the root that the slope promises, and never a tiny step.
    const double wish = -1.3 * value / search.slope;
    const double step = std::copysign(std::max(std::abs(wish), 10.0 * search.tolerance), wish);
    const double next = std::clamp(x + step, search.least, search.most);
    const double at_next = remembered(next);
    if (next == x) {
      remembered.rethrow();
      return remembered.best(false);
    }
    if (at_next == 0.0 || (at_next > 0.0) != (value > 0.0)) {
      brent(remembered, std::min(x, next), std::max(x, next), search.tolerance);
      break;
    }
    x = next;
    value = at_next;
  }
  remembered.rethrow();
  return remembered.best(true);
}

} // namespace tremolo::soiltest
