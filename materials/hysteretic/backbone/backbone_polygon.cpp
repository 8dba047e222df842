#include "materials/hysteretic/backbone/backbone_polygon.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials {
namespace {

/// q = gamma^2 |F''|/F, which for F = G0 gamma/(1 + r) and MKZ is s r [(1 + s) + (1 - s) r]/(1 + r)^2. For
/// other backbones it follows from the tangent, gamma F'' = dF'/d(ln gamma).
double curvature(const Backbone& backbone, double strain) {
  if (!backbone.shape) {
    const double s = backbone.exponent;
    const double r = backbone.reduction(strain);
    return s * r * ((1.0 + s) + (1.0 - s) * r) / ((1.0 + r) * (1.0 + r));
  }
  constexpr double step = 1e-3; // of ln gamma
  const double change =
      backbone.tangent(strain * std::exp(step)) - backbone.tangent(strain * std::exp(-step));
  return std::abs(change) / (2.0 * step * backbone.secant(strain));
}

/// int sqrt(q) d(ln gamma) from ln gamma = `low` to points of an even grid up to `high`.
std::vector<double> sides_until(const Backbone& backbone, double low, double high) {
  constexpr std::size_t intervals = 2000;
  const double h = (high - low) / intervals;
  std::vector<double> integral(intervals + 1, 0.0);
  for (std::size_t k = 1; k <= intervals; ++k) {
    const double middle = low + (static_cast<double>(k) - 0.5) * h;
    integral[k] = integral[k - 1] + std::sqrt(curvature(backbone, std::exp(middle))) * h;
  }
  return integral;
}

} // namespace

std::vector<CurveVertex> polygon(const Backbone& backbone, std::size_t count, double largest_strain) {
  const double sides = static_cast<double>(count - 1);
  const double high = std::log(largest_strain);
  const auto excess_at = [&](double log_strain) { return backbone.reduction(std::exp(log_strain)); };
  double below = high - 60.0 / backbone.exponent; // ln of the strain at the end of the first side
  double above = high;
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (below + above);
    const bool small =
        sides * 4.0 * std::sqrt(excess_at(middle)) < sides_until(backbone, middle, high).back();
    (small ? below : above) = middle;
  }
  const double low = 0.5 * (below + above);
  const std::vector<double> integral = sides_until(backbone, low, high);
  const double h = (high - low) / static_cast<double>(integral.size() - 1);
  const double excess = excess_at(low);
  std::vector<CurveVertex> vertices;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = integral.back() * static_cast<double>(i) / sides;
    const auto next = std::upper_bound(integral.begin() + 1, integral.end() - 1, wanted);
    const double fraction = (wanted - *(next - 1)) / (*next - *(next - 1));
    const double strain = std::exp(low + h * (static_cast<double>(next - 1 - integral.begin()) + fraction));
    vertices.push_back({strain, (1.0 + excess) * backbone.stress(strain)});
  }
  return vertices;
}

} // namespace tremolo::materials
