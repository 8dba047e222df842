#include "materials/iwan_shear.hpp"

#include "materials/parameter_check.hpp"

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

/// The polygon's vertices and how far they lie above the backbone, relative.
struct Polygon {
  std::vector<double> strain;
  double excess;
};

Polygon polygon(const Backbone& backbone, const IwanFit& fit) {
  const double s = backbone.exponent;
  const double sides = static_cast<double>(fit.elements - 1);
  const double high = std::log(backbone.reduction(fit.largest_strain));
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
  Polygon result{{}, std::exp(low)};
  for (std::size_t i = 0; i < fit.elements; ++i) {
    const double wanted = integral.back() * static_cast<double>(i) / sides;
    const auto next = std::upper_bound(integral.begin() + 1, integral.end() - 1, wanted);
    const double fraction = (wanted - *(next - 1)) / (*next - *(next - 1));
    const double log_r = low + h * (static_cast<double>(next - 1 - integral.begin()) + fraction);
    result.strain.push_back(backbone.reference_strain * std::pow(std::exp(log_r) / backbone.beta, 1.0 / s));
  }
  return result;
}

void check(const IwanFit& fit) {
  check_element_count(fit.elements);
  check_range("largest_strain", fit.largest_strain, 1e-6, 10.0);
}

} // namespace

IwanShear iwan_shear(const Elasticity& elastic, double reference_strain, double beta, double exponent,
                     const IwanFit& fit) {
  check(elastic);
  check(fit);
  const Backbone backbone = {elastic.shear_modulus(), reference_strain, beta, exponent};
  validate(backbone);
  const Polygon line = polygon(backbone, fit);
  std::vector<CurveVertex> vertices;
  for (const double strain : line.strain) {
    vertices.push_back({strain, (1.0 + line.excess) * backbone.stress(strain)});
  }
  return {elastic, parallel_elements(vertices)};
}

double monotonic_stress(const IwanShear& law, double strain) {
  return monotonic_stress(std::span(law.elements), strain);
}

void update(const IwanShear& law, const Points& points) {
  update(law.elastic, law.elements, points);
}

void validate(const IwanShear& law) {
  validate(law.elastic, law.elements);
}

} // namespace tremolo::materials
