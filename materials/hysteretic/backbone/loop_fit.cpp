// For a given p3 the sum is a quadratic of u = p1 - p2 and v = p2, F = u + v (1 - z) with z = (1 -
// G_m/G0)^p3, whose least value on the triangle u, v >= 0, u + v <= 1 lies inside or on a side. p3 is
// searched on a grid, and again between the neighbours of the best.

#include "materials/hysteretic/backbone/loop_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tremolo::materials {
namespace {

constexpr double least_exponent = 0.1;
constexpr double largest_exponent = 10.0;

/// A row of the curve.
struct Row {
  double lost;   ///< 1 - G_m/G0
  double masing; ///< damping of the Masing rules
  double wanted; ///< D_i - D_1
};

double squares(const std::vector<Row>& rows, const LoopReduction& loops) {
  double sum = 0.0;
  for (const Row& row : rows) {
    const double factor = loops.at_small_strain - loops.loss * std::pow(row.lost, loops.exponent);
    const double residual = factor * row.masing - row.wanted;
    sum += residual * residual;
  }
  return sum;
}

/// Normal equations of F D_Masing = a u + b v.
struct Normal {
  double aa = 0.0, ab = 0.0, bb = 0.0, ac = 0.0, bc = 0.0;
};

/// Best u and v at a p3.
LoopReduction best_at(const std::vector<Row>& rows, double exponent) {
  Normal n;
  for (const auto& [lost, masing, wanted] : rows) {
    const double b = masing * (1.0 - std::pow(lost, exponent));
    n.aa += masing * masing;
    n.ab += masing * b;
    n.bb += b * b;
    n.ac += masing * wanted;
    n.bc += b * wanted;
  }
  const auto reduction = [&](double u, double v) { return LoopReduction{u + v, v, exponent}; };
  const auto along = [](double numerator, double denominator) {
    return denominator > 0.0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0.0;
  };
  std::vector<LoopReduction> candidates;
  if (const double determinant = n.aa * n.bb - n.ab * n.ab; determinant > 1e-12 * n.aa * n.bb) {
    const double u = (n.ac * n.bb - n.bc * n.ab) / determinant;
    const double v = (n.bc * n.aa - n.ac * n.ab) / determinant;
    if (u >= 0.0 && v >= 0.0 && u + v <= 1.0)
      candidates.push_back(reduction(u, v));
  }
  candidates.push_back(reduction(along(n.ac, n.aa), 0.0));
  candidates.push_back(reduction(0.0, along(n.bc, n.bb)));
  const double u = along(n.ac - n.bc - n.ab + n.bb, n.aa - 2.0 * n.ab + n.bb); // v = 1 - u
  candidates.push_back(reduction(u, 1.0 - u));
  return *std::ranges::min_element(candidates, {},
                                   [&](const LoopReduction& one) { return squares(rows, one); });
}

/// Best of an even grid of ln p3 between two exponents.
LoopReduction best_between(const std::vector<Row>& rows, double low, double high) {
  constexpr int intervals = 100;
  LoopReduction best = best_at(rows, low);
  for (int k = 1; k <= intervals; ++k) {
    const LoopReduction one = best_at(rows, low * std::pow(high / low, static_cast<double>(k) / intervals));
    if (squares(rows, one) < squares(rows, best))
      best = one;
  }
  return best;
}

} // namespace

LoopReduction fit_loop_reduction(const SoilCurves& curves, const Backbone& backbone) {
  validate(curves);
  validate(backbone);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < curves.strain.size(); ++i) {
    const double strain = curves.strain[i];
    rows.push_back({1.0 - backbone.secant(strain) / backbone.shear_modulus, masing_damping(backbone, strain),
                    std::max(curves.damping_ratio[i] - curves.damping_ratio.front(), 0.0)});
  }
  const LoopReduction coarse = best_between(rows, least_exponent, largest_exponent);
  const double step = std::pow(largest_exponent / least_exponent, 0.01);
  return best_between(rows, std::max(coarse.exponent / step, least_exponent),
                      std::min(coarse.exponent * step, largest_exponent));
}

} // namespace tremolo::materials
