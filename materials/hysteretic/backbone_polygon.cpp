#include "materials/hysteretic/backbone_polygon.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials {
namespace {

/// sqrt(q) of the polygon's spacing as a function of r = beta x^s: with F = G0 gamma/(1 + r),
/// q = gamma^2 |F''|/F = s r [(1 + s) + (1 - s) r]/(1 + r)^2.
double root_curvature(double r, double s) {
  return std::sqrt(s * r * ((1.0 + s) + (1.0 - s) * r)) / (1.0 + r);
}

/// int sqrt(q) d(ln gamma) from ln r = `low` to points of an even grid up to `high`, ln r = s ln gamma +
/// const.
std::vector<double> sides_until(double low, double high, double s) {
  constexpr std::size_t intervals = 2000;
  const double h = (high - low) / intervals;
  std::vector<double> integral(intervals + 1, 0.0);
  for (std::size_t k = 1; k <= intervals; ++k) {
    const double middle = low + (static_cast<double>(k) - 0.5) * h;
    integral[k] = integral[k - 1] + root_curvature(std::exp(middle), s) * h / s;
  }
  return integral;
}

} // namespace

std::vector<CurveVertex> polygon(const Backbone& backbone, std::size_t count, double largest_strain) {
  const double s = backbone.exponent;
  const double sides = static_cast<double>(count - 1);
  const double high = std::log(backbone.reduction(largest_strain));
  double below = high - 60.0; // ln e
  double above = high;
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (below + above);
    const bool small = sides * 4.0 * std::exp(0.5 * middle) < sides_until(middle, high, s).back();
    (small ? below : above) = middle;
  }
  const double low = 0.5 * (below + above);
  const std::vector<double> integral = sides_until(low, high, s);
  const double h = (high - low) / static_cast<double>(integral.size() - 1);
  const double excess = std::exp(low);
  std::vector<CurveVertex> vertices;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = integral.back() * static_cast<double>(i) / sides;
    const auto next = std::upper_bound(integral.begin() + 1, integral.end() - 1, wanted);
    const double fraction = (wanted - *(next - 1)) / (*next - *(next - 1));
    const double log_r = low + h * (static_cast<double>(next - 1 - integral.begin()) + fraction);
    const double strain = backbone.reference_strain * std::pow(std::exp(log_r) / backbone.beta, 1.0 / s);
    vertices.push_back({strain, (1.0 + excess) * backbone.stress(strain)});
  }
  return vertices;
}

} // namespace tremolo::materials
