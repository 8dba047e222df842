#include "materials/iwan_shear.hpp"

#include "materials/objective_rate.hpp"
#include "materials/parameter_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tremolo::materials {
namespace {

/// What a step asks of every element: twice the deviatoric strain, and the rotation by its double angle.
struct Step {
  double xx;
  double yy;
  double xy;
  double cosine;
  double sine;
};

Step step_of(const Points& points, std::size_t i) {
  const InPlaneStress turned = rotated({1.0, -1.0, 0.0}, points.dwxy[i]); // cosine, -cosine, sine
  const double mean = (points.dexx[i] + points.deyy[i]) / 3.0;
  return {2.0 * (points.dexx[i] - mean), 2.0 * (points.deyy[i] - mean), points.dgxy[i], turned.xx, turned.xy};
}

using Group = std::array<double, iwan_group>;

/// In-plane deviatoric stress that yielding takes from the trial stress, Pa.
struct Relaxed {
  Group xx{};
  Group yy{};
  Group xy{};
};

/// Moves one group of elements by a step. No branch, so that it runs on vectors.
/// @param s  the group's part of the state block
void move_group(const IwanElement* elements, const Step& step, double* s, Relaxed& relaxed) {
  constexpr std::size_t n = iwan_group;
  for (std::size_t k = 0; k < n; ++k) {
    const double modulus = elements[k].shear_modulus;
    const double strength = elements[k].strength;
    const double mean = 0.5 * (s[k] + s[n + k]);
    const double half = 0.5 * (s[k] - s[n + k]);
    const double half_rotated = half * step.cosine - s[2 * n + k] * step.sine;
    const double xx = mean + half_rotated + modulus * step.xx;
    const double yy = mean - half_rotated + modulus * step.yy;
    const double xy = half * step.sine + s[2 * n + k] * step.cosine + modulus * step.xy;
    const double j2 = xx * xx + yy * yy + xx * yy + xy * xy; // s_zz = -s_xx - s_yy
    const double over = std::max(j2, strength * strength);
    const double scale = j2 > strength * strength ? strength / std::sqrt(over) : 1.0;
    s[k] = scale * xx;
    s[n + k] = scale * yy;
    s[2 * n + k] = scale * xy;
    relaxed.xx[k] += xx - s[k];
    relaxed.yy[k] += yy - s[n + k];
    relaxed.xy[k] += xy - s[2 * n + k];
  }
}

double sum(const Group& group) {
  return (group[0] + group[1]) + (group[2] + group[3]);
}

/// sigma <- Q sigma Q^T + C : d_eps - relaxed, and the plastic work of the mean stress of the step.
void move_point(const IwanShear& law, double lame, double shear, const Points& points, std::size_t i) {
  const Step step = step_of(points, i);
  Relaxed relaxed;
  double* const state = points.state + i * 3 * law.elements.size();
  for (std::size_t first = 0; first < law.elements.size(); first += iwan_group) {
    move_group(&law.elements[first], step, state + 3 * first, relaxed);
  }
  const double rxx = sum(relaxed.xx);
  const double ryy = sum(relaxed.yy);
  const double rxy = sum(relaxed.xy);

  const InPlaneStress carried = rotated({points.sxx[i], points.syy[i], points.sxy[i]}, points.dwxy[i]);
  const double pressure = lame * (points.dexx[i] + points.deyy[i]);
  const double sxx = carried.xx + pressure + 2.0 * shear * points.dexx[i] - rxx;
  const double syy = carried.yy + pressure + 2.0 * shear * points.deyy[i] - ryy;
  const double szz = points.szz[i] + pressure + rxx + ryy;
  const double sxy = carried.xy + shear * points.dgxy[i] - rxy;
  points.plastic_work[i] += 0.25 / shear *
                            ((carried.xx + sxx) * rxx + (carried.yy + syy) * ryy -
                             (points.szz[i] + szz) * (rxx + ryy) + 2.0 * (carried.xy + sxy) * rxy);
  points.sxx[i] = sxx;
  points.syy[i] = syy;
  points.szz[i] = szz;
  points.sxy[i] = sxy;
}

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
  if (fit.elements < iwan_group || fit.elements > most_iwan_elements || fit.elements % iwan_group != 0) {
    throw std::invalid_argument(fmt::format("elements = {} must be a multiple of {} in [{}, {}]",
                                            fit.elements, iwan_group, iwan_group, most_iwan_elements));
  }
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
  const auto height = [&](std::size_t i) { return (1.0 + line.excess) * backbone.stress(line.strain[i]); };
  IwanShear law{elastic, {}};
  double slope = backbone.shear_modulus;
  for (std::size_t i = 0; i < fit.elements; ++i) {
    const bool last = i + 1 == fit.elements;
    const double next = last ? 0.0 : (height(i + 1) - height(i)) / (line.strain[i + 1] - line.strain[i]);
    law.elements.push_back({slope - next, (slope - next) * line.strain[i]});
    slope = next;
  }
  return law;
}

double monotonic_stress(const IwanShear& law, double strain) {
  double stress = 0.0;
  for (const IwanElement& element : law.elements) {
    stress += std::clamp(element.shear_modulus * strain, -element.strength, element.strength);
  }
  return stress;
}

void update(const IwanShear& law, const Points& points) {
  const double lame = law.elastic.lame();
  const double shear = law.elastic.shear_modulus();
  for (std::size_t i = 0; i < points.count; ++i) {
    move_point(law, lame, shear, points, i);
  }
}

void validate(const IwanShear& law) {
  check(law.elastic);
  check(IwanFit{.elements = law.elements.size()});
  double modulus = 0.0;
  for (const IwanElement& element : law.elements) {
    check_positive("shear modulus of an Iwan element", element.shear_modulus);
    check_positive("strength of an Iwan element", element.strength);
    modulus += element.shear_modulus;
  }
  const double wanted = law.elastic.shear_modulus();
  check_range("sum of the Iwan elements' shear moduli", modulus, (1.0 - 1e-9) * wanted,
              (1.0 + 1e-9) * wanted);
}

} // namespace tremolo::materials
