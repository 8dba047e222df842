#include "materials/law/mixed_control.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::materials {
namespace {

using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;
using Eigen::Index;

constexpr double refused = std::numeric_limits<double>::infinity();
constexpr double largest_correction = 0.01; // strain

// Fractions of the largest strain increment of a step: the distance of a root from its expected position
// beyond which a nearer one is sought, the first search distance, and the distance beyond which it belongs to
// another branch.
constexpr double surely_near = 0.05;
constexpr double first_look = 0.05;
constexpr double another_branch = 0.5;

double norm(const Vector& r) {
  return r.size() == 0 ? 0.0 : r.lpNorm<Eigen::Infinity>();
}

/// The equations of one step.
class Equations {
public:
  Equations(const MixedStep& step, const StressAfter& stress_after)
      : step_(step), stress_after_(stress_after) {
    for (std::size_t i = 0; i < 4; ++i)
      if (step.by_stress[i])
        free_[static_cast<std::size_t>(size_++)] = i;
  }

  Index size() const { return size_; }
  std::size_t component(Index k) const { return free_[static_cast<std::size_t>(k)]; }

  /// The strain increment with given free components.
  Components strain(const Vector& x) const {
    Components all;
    for (std::size_t i = 0; i < 4; ++i)
      all[i] = step_.by_stress[i] ? 0.0 : step_.value[i];
    for (Index k = 0; k < size_; ++k)
      all[component(k)] = x[k];
    return all;
  }

  /// Largest component of that increment.
  double largest(const Vector& x) const {
    double most = 0.0;
    for (const double component : strain(x))
      most = std::max(most, std::abs(component));
    return most;
  }

  Vector residual(const Vector& x) const {
    const Components all = strain(x);
    Components stress = {};
    Vector r = Vector::Constant(size_, refused);
    if (!stress_after_(all, stress))
      return r;
    const double water = step_.pore_stiffness * (all[0] + all[1] + all[3]);
    for (Index k = 0; k < size_; ++k) {
      const std::size_t i = component(k);
      r[k] = stress[i] + (i == 2 ? 0.0 : water) - step_.value[i];
    }
    return r;
  }

  /// Columns by forward differences; not finite if the law refuses one of them.
  Matrix tangent(const Vector& x, const Vector& r) const {
    const double change = std::max(0.01 * largest(x), 1e-12);
    Matrix columns(size_, size_);
    for (Index k = 0; k < size_; ++k) {
      Vector moved = x;
      moved[k] += x[k] < 0.0 ? -change : change;
      columns.col(k) = (residual(moved) - r) / (moved[k] - x[k]);
    }
    return columns;
  }

private:
  const MixedStep& step_;
  const StressAfter& stress_after_;
  std::array<std::size_t, 4> free_ = {};
  Index size_ = 0;
};

/// Newton's method with a tangent that may come from an earlier step.
class Newton {
public:
  Newton(const Equations& equations, double wanted, double accepted)
      : equations_(equations), wanted_(wanted), accepted_(accepted) {}

  void run(const Vector& start, Matrix& tangent, bool has_tangent) {
    x_ = start;
    r_ = equations_.residual(x_);
    if (norm(r_) <= wanted_ || !r_.allFinite())
      return;
    bool fresh = !has_tangent;
    if (fresh)
      tangent = equations_.tangent(x_, r_);
    for (int iteration = 0; iteration < most_iterations && norm(r_) > wanted_; ++iteration) {
      const Matrix before = tangent;
      if (step(tangent, 1.0, 0.5)) {
        fresh = false;
      } else if (!fresh) {
        tangent = equations_.tangent(x_, r_);
        fresh = true;
      } else if (search(before)) {
        tangent = before;
        fresh = false;
      } else {
        break;
      }
    }
    if (r_.size() != 1)
      return;
    if (norm(r_) > accepted_)
      bisect(largest_correction);
    else
      prefer_nearer(start);
  }

  const Vector& x() const { return x_; }
  double missing() const { return norm(r_); }

private:
  /// A fraction of the Newton step, taken if it leaves less than `left` of the residual.
  bool step(Matrix& tangent, double fraction, double left) {
    if (!tangent.allFinite())
      return false;
    Vector change = -fraction * tangent.fullPivLu().solve(r_);
    const double size = norm(change);
    if (!change.allFinite() || !(size > 0.0))
      return false;
    if (size > largest_correction)
      change *= largest_correction / size;
    const Vector x = x_ + change;
    const Vector r = equations_.residual(x);
    const bool taken = norm(r) <= left * norm(r_);
    if (r.allFinite())
      tangent += (r - r_ - tangent * change) * change.transpose() / change.squaredNorm();
    if (taken) {
      x_ = x;
      r_ = r;
    }
    return taken;
  }

  bool search(const Matrix& tangent) {
    for (const double fraction : {1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015625}) {
      Matrix corrected = tangent;
      if (step(corrected, fraction, 1.0 - 0.1 * fraction))
        return true;
    }
    return false;
  }

  /// A point on the way to a root of one unknown.
  struct Point {
    double x;
    double r;
  };

  Point at(double x) {
    Vector moved = x_;
    moved[0] = x;
    const Vector r = equations_.residual(moved);
    if (std::abs(r[0]) < norm(r_)) {
      x_[0] = x;
      r_ = r;
    }
    return {x, r[0]};
  }

  /// If several strains give the stress, the soil takes the first one on its path: a root away from the start
  /// gives way to one in between.
  void prefer_nearer(const Vector& start) {
    const double distance = std::abs(x_[0] - start[0]);
    if (distance <= surely_near * equations_.largest(start))
      return;
    const Vector far_x = x_;
    const Vector far_r = r_;
    x_ = start;
    r_ = equations_.residual(start);
    bisect(distance);
    if (norm(r_) > accepted_) {
      x_ = far_x;
      r_ = far_r;
    }
  }

  /// One free component whose residual is not monotonic: a change of sign is looked for on both sides in
  /// growing steps, first where more strain means more stress, and closed in on. Where the residual jumps
  /// from one sign to the other there is no root, and the search goes on.
  /// @param farthest  strain from here within which it is looked for
  void bisect(double farthest) {
    const Point start = {x_[0], r_[0]};
    Point near[2] = {start, start};
    double distance = std::max(first_look * equations_.largest(x_), 1e-12);
    while (distance < farthest) {
      for (Point& last : near) {
        const double side = (&last == near) == (start.r > 0.0) ? -1.0 : 1.0;
        const Point next = at(start.x + side * distance);
        if (std::isfinite(next.r) && (next.r > 0.0) != (last.r > 0.0)) {
          close_in(last, next);
          if (norm(r_) <= accepted_)
            return;
        }
        last = std::isfinite(next.r) ? next : last;
      }
      distance *= 1.5;
    }
  }

  void close_in(Point a, Point b) {
    for (int k = 0; k < 60 && norm(r_) > wanted_; ++k) {
      const Point middle = at(0.5 * (a.x + b.x));
      ((middle.r > 0.0) == (a.r > 0.0) ? a : b) = middle;
    }
  }

  static constexpr int most_iterations = 25;
  const Equations& equations_;
  double wanted_;
  double accepted_;
  Vector x_;
  Vector r_;
};

/// Result of Newton's method.
struct Root {
  Vector x;
  double missing;  ///< Pa
  double distance; ///< from the start, of one free component
  double step;     ///< largest strain increment that was expected
};

} // namespace

/// The free increments of an earlier step, in proportion to the prescribed ones; 0 where these turn back.
double MixedControl::Increments::ratio_to(const MixedStep& step) const {
  double along = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!step.by_stress[i]) {
      along += step.value[i] * prescribed[i];
      square += prescribed[i] * prescribed[i];
    }
  }
  return square > 0.0 ? std::max(0.0, along / square) : 0.0;
}

MixedControl::Found MixedControl::find(const MixedStep& step, const StressAfter& stress_after, double wanted,
                                       double accepted) {
  const Equations equations(step, stress_after);
  const Index n = equations.size();
  const bool same = step.by_stress == by_stress_;
  Matrix tangent(n, n);
  const auto expected = [&](const std::optional<Increments>& before) {
    const double ratio = same && before ? before->ratio_to(step) : 0.0;
    Vector x = Vector::Zero(n);
    for (Index k = 0; k < n && ratio > 0.0; ++k)
      x[k] = ratio * before->strain[equations.component(k)];
    return x;
  };
  const auto solved_from = [&](const Vector& start) {
    for (Index k = 0; k < n * n; ++k) {
      tangent(k / n, k % n) = tangent_[static_cast<std::size_t>(k)];
    }
    Newton newton(equations, wanted, accepted);
    newton.run(start, tangent, same && has_tangent_);
    const double distance = n == 1 ? std::abs(newton.x()[0] - start[0]) : 0.0;
    return Root{newton.x(), newton.missing(), distance, equations.largest(start)};
  };
  const auto near = [&](const Root& root) {
    return root.missing <= accepted && root.distance <= surely_near * root.step;
  };

  // Steps repeat themselves. After a leap, the way before it is tried first.
  const bool goes_on = same && last_ && last_->ratio_to(step) > 0.0;
  if (!goes_on) {
    away_ = false;
    steady_.reset();
  }
  Root root = solved_from(expected(away_ ? steady_ : last_));
  if (away_ && near(root))
    away_ = false;
  else if (away_)
    root = solved_from(expected(last_));
  const bool found = root.missing <= accepted;
  const bool leaps = goes_on && steady_ && found && root.distance > another_branch * root.step;
  away_ = found && (away_ || leaps);

  by_stress_ = step.by_stress;
  const Components strain = equations.strain(root.x);
  last_ = found ? std::optional(Increments{step.value, strain}) : std::nullopt;
  if (!away_ && (near(root) || !steady_))
    steady_ = last_;
  has_tangent_ = found && tangent.allFinite();
  for (Index k = 0; k < n * n; ++k)
    tangent_[static_cast<std::size_t>(k)] = tangent(k / n, k % n);
  return {strain, root.missing, leaps ? root.distance : 0.0, away_};
}

} // namespace tremolo::materials
