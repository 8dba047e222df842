#pragma once

// The load of a rigid strip footing on weightless clay whose strength grows with depth, c = c_0 + rho z, by
// slip lines (Davis and Booker 1973, Geotechnique 23, 551-563). With z down, compression positive and theta
// from z to the larger principal stress,
//
//     sigma_z = p + c cos 2 theta,  sigma_x = p - c cos 2 theta,  tau = c sin 2 theta,
//
// equilibrium is
//
//     dx/dz = tan(theta + pi/4):  dp + 2 c dtheta + rho dx = 0   (plus lines)
//     dx/dz = tan(theta - pi/4):  dp - 2 c dtheta - rho dx = 0   (minus lines).
//
// From the free surface (p = c_0, theta = pi/2) beside the right edge of the footing, x = z = 0, the field is
// continued through a fan at this edge, in which p = c_0 + 2 c_0 (pi/2 - theta), to the footing at x < 0.
// Under a smooth footing theta = 0 at z = 0. Under a rough one a wedge moves with it, between the axis and
// the minus line from the edge that meets the axis at theta = 0; the load is what acts on this line.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace tremolo::mpm_domain::test {

class SlipLines {
public:
  /// @param surface  strength c_0 at z = 0, Pa
  /// @param growth   rho, Pa/m
  SlipLines(double surface, double growth, double width)
      : surface_(surface), growth_(growth), width_(width) {}

  /// Mean pressure, Pa.
  double smooth() const {
    const double reach = root(0.05, 2.0, [&](double length) { return reached(footing(length).back()); });
    const Line found = footing(reach);
    double load = 0.0;
    for (std::size_t i = 1; i < found.size(); ++i)
      load += 0.5 * (found[i - 1].x - found[i].x) * (found[i - 1].p + found[i].p);
    return load / (0.5 * width_) + surface_; // sigma_z = p + c_0
  }

  /// Mean pressure, Pa; while the fan does not reach the footing, rho B at most c_0.
  double rough() const {
    const auto wedge = [&](double angle) {
      return fan(root(0.05, 2.0, [&](double length) { return reached(fan(length, angle).back()); }), angle);
    };
    const Line found =
        wedge(root(-quarter, 0.5 * quarter, [&](double angle) { return wedge(angle).back().theta; }));
    double load = 0.0;
    for (std::size_t i = 1; i < found.size(); ++i) {
      const double theta = 0.5 * (found[i - 1].theta + found[i].theta);
      const double c = 0.5 * (strength(found[i - 1].z) + strength(found[i].z));
      const double p = 0.5 * (found[i - 1].p + found[i].p);
      load += (p + c * std::cos(2.0 * theta)) * (found[i - 1].x - found[i].x) +
              c * std::sin(2.0 * theta) * (found[i].z - found[i - 1].z);
    }
    return load / (0.5 * width_);
  }

private:
  struct State {
    double x, z, p, theta;
  };
  using Line = std::vector<State>;
  static constexpr double quarter = 0.25 * std::numbers::pi;
  static constexpr int along = 60, turns = 40; ///< intervals along the surface, and of the fan

  double strength(double z) const { return surface_ + growth_ * z; }
  /// How far the axis lies behind a point, over the width; negative beyond it.
  double reached(const State& point) const { return 0.5 + point.x / width_; }

  /// Where a function that has one sign at `low` and the other at `high` is zero.
  template <class Function>
  static double root(double low, double high, const Function& f) {
    const bool sign = f(low) > 0.0;
    for (int i = 0; i < 26; ++i) {
      const double middle = 0.5 * (low + high);
      ((f(middle) > 0.0) == sign ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  /// Where the plus line of one point meets the minus line of another.
  State meet(const State& a, const State& b) const {
    State at{0.5 * (a.x + b.x), 0.5 * (a.z + b.z), 0.0, 0.5 * (a.theta + b.theta)};
    for (int i = 0; i < 8; ++i) {
      const double plus = 0.5 * (a.theta + at.theta) + quarter;
      const double minus = 0.5 * (b.theta + at.theta) - quarter;
      const double of_a = a.x * std::cos(plus) - a.z * std::sin(plus);
      const double of_b = b.x * std::cos(minus) - b.z * std::sin(minus);
      const double determinant = std::sin(plus - minus);
      const double c_a = strength(0.5 * (a.z + at.z));
      const double c_b = strength(0.5 * (b.z + at.z));
      at.x = (of_b * std::sin(plus) - of_a * std::sin(minus)) / determinant;
      at.z = (of_b * std::cos(plus) - of_a * std::cos(minus)) / determinant;
      const double along_plus = a.p + 2.0 * c_a * a.theta - growth_ * (at.x - a.x);
      const double along_minus = b.p - 2.0 * c_b * b.theta + growth_ * (at.x - b.x);
      at.theta = 0.5 * (along_plus - along_minus) / (c_a + c_b);
      at.p = along_plus - 2.0 * c_a * at.theta;
    }
    return at;
  }

  /// Where the plus line of a point meets a smooth footing.
  State meet_footing(const State& a) const {
    const double x = a.x - a.z * std::tan(0.5 * a.theta + quarter);
    return {x, 0.0, a.p + 2.0 * strength(0.5 * a.z) * a.theta - growth_ * (x - a.x), 0.0};
  }

  /// The minus line from the edge at which the fan ends.
  /// @param length  of the free surface that the field begins with, over the width
  Line fan(double length, double angle) const {
    Line level;
    for (int i = 0; i <= along; ++i)
      level.push_back({length * width_ * i / along, 0.0, surface_, 2.0 * quarter});
    Line line{level.front()};
    while (level.size() > 1) {
      for (std::size_t i = 0; i + 1 < level.size(); ++i)
        level[i] = meet(level[i + 1], level[i]);
      level.pop_back();
      line.push_back(level.front());
    }
    for (int j = 1; j <= turns; ++j) {
      const double theta = 2.0 * quarter + (angle - 2.0 * quarter) * j / turns;
      line.front() = {0.0, 0.0, surface_ * (1.0 + 2.0 * (2.0 * quarter - theta)), theta};
      for (std::size_t i = 1; i < line.size(); ++i)
        line[i] = meet(line[i], line[i - 1]);
    }
    return line;
  }

  /// Points of a smooth footing, from its edge on.
  Line footing(double length) const {
    Line line = fan(length, 0.0);
    Line points{line.front()};
    while (line.size() > 1) {
      line.erase(line.begin());
      line.front() = meet_footing(line.front());
      points.push_back(line.front());
      for (std::size_t i = 1; i < line.size(); ++i)
        line[i] = meet(line[i], line[i - 1]);
    }
    return points;
  }

  double surface_, growth_, width_;
};

} // namespace tremolo::mpm_domain::test
