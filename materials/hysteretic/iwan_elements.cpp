#include "materials/hysteretic/iwan_elements.hpp"

#include "materials/elastic/elastic_trial.hpp"
#include "materials/law/parameter_check.hpp"
#include "materials/tensor/objective_rate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tremolo::materials {
namespace {

/// Numbered names stay where they are, for the variables that view them.
struct Table {
  std::vector<std::string> names;
  std::vector<StateVariable> variables;

  explicit Table(bool reduced) {
    names.reserve(3 * most_iwan_elements);
    if (reduced)
      variables = {{"strain_xx", "1", "deviatoric strain since the initial state", 0.0},
                   {"strain_yy", "1", "deviatoric strain since the initial state", 0.0},
                   {"strain_xy", "1", "tensor shear strain since the initial state", 0.0},
                   {"largest_shear_strain", "1", "largest engineering shear strain so far", 0.0}};
    for (std::size_t first = 1; first <= most_iwan_elements; first += iwan_group) {
      for (const char* component : {"xx", "yy", "xy"}) {
        for (std::size_t k = 0; k < iwan_group; ++k) {
          names.push_back(fmt::format("element_{:02}_s{}", first + k, component));
          variables.push_back({names.back(), "Pa", "deviatoric stress of an Iwan element", 0.0, true});
        }
      }
    }
  }
};

/// Input of a step to every element: twice the deviatoric strain, and the rotation by its double angle.
struct Step {
  double xx;
  double yy;
  double xy;
  double cosine;
  double sine;
};

Step step_of(const Points& points, std::size_t i) {
  const InPlaneStress turned = rotated({1.0, -1.0, 0.0}, points.dwxy[i]); // cosine, -cosine, sine
  const double mean = (points.dexx[i] + points.deyy[i] + out_of_plane_strain(points, i)) / 3.0;
  return {2.0 * (points.dexx[i] - mean), 2.0 * (points.deyy[i] - mean), points.dgxy[i], turned.xx, turned.xy};
}

/// Entries of a state block before the element stresses, where loops are reduced.
constexpr std::size_t reduced_entries = 4;

using Group = std::array<double, iwan_group>;

/// Reduction of the in-plane deviatoric trial stress by yielding, Pa.
struct Relaxed {
  Group xx{};
  Group yy{};
  Group xy{};
};

/// Added to every element stress, Pa: nothing beside any stress, but in steady shear the other components
/// shrink with every step, and arithmetic with denormal numbers would take ten times as long as all the rest.
constexpr double never_denormal = 1e-140;

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
    s[k] = scale * xx + never_denormal;
    s[n + k] = scale * yy + never_denormal;
    s[2 * n + k] = scale * xy + never_denormal;
    relaxed.xx[k] += xx - s[k];
    relaxed.yy[k] += yy - s[n + k];
    relaxed.xy[k] += xy - s[2 * n + k];
  }
}

double sum(const Group& group) {
  return (group[0] + group[1]) + (group[2] + group[3]);
}

/// An in-plane deviatoric tensor; zz = -xx - yy.
struct Deviator {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
};

/// a x + b y
Deviator combined(double a, const Deviator& x, double b, const Deviator& y) {
  return {a * x.xx + b * y.xx, a * x.yy + b * y.yy, a * x.xy + b * y.xy};
}

Deviator sum_of_stresses(const double* s, std::size_t elements) {
  Deviator total;
  for (std::size_t first = 0; first < elements; first += iwan_group, s += 3 * iwan_group)
    for (std::size_t k = 0; k < iwan_group; ++k)
      total = combined(1.0, total, 1.0, {s[k], s[iwan_group + k], s[2 * iwan_group + k]});
  return total;
}

/// F S + (1 - F) 2 G_m e
Deviator reduced_stress(std::span<const IwanElement> elements, const LoopReduction& loops, double shear,
                        const Deviator& sum, const Deviator& strain, double largest) {
  const double secant = largest > 0.0 ? monotonic_stress(elements, largest) / largest : shear;
  const double share = loops.factor(std::max(shear / secant - 1.0, 0.0));
  return combined(share, sum, 2.0 * (1.0 - share) * secant, strain);
}

/// Reduction of the trial stress in a step for reduced loops, given the reduction by the elements.
/// @param spin    rotation of the step, rad
/// @param memory  e_xx, e_yy, e_xy, gamma_m
Deviator relaxed_by_reduced(std::span<const IwanElement> elements, const LoopReduction& loops, double shear,
                            const Step& step, double spin, const Deviator& relaxed, const double* stresses,
                            double* memory) {
  const Deviator trial = {shear * step.xx, shear * step.yy, shear * step.xy};
  const Deviator after = sum_of_stresses(stresses, elements.size());
  const Deviator before = combined(1.0, combined(1.0, after, 1.0, relaxed), -1.0, trial);
  const InPlaneStress turned =
      rotated({memory[0], memory[1], memory[2]}, spin); // a strain turns as a stress does
  const Deviator carried = {turned.xx, turned.yy, turned.xy};
  const Deviator e = combined(1.0, carried, 0.5, {step.xx, step.yy, step.xy});
  const double shear_strain = 2.0 * std::sqrt(e.xx * e.xx + e.yy * e.yy + e.xx * e.yy + e.xy * e.xy);
  const double largest = std::max(memory[3], shear_strain);
  const Deviator change = combined(1.0, reduced_stress(elements, loops, shear, after, e, largest), -1.0,
                                   reduced_stress(elements, loops, shear, before, carried, memory[3]));
  memory[0] = e.xx;
  memory[1] = e.yy;
  memory[2] = e.xy;
  memory[3] = largest;
  return combined(1.0, trial, -1.0, change);
}

/// sigma <- Q sigma Q^T + C : d_eps - relaxed, and the plastic work of the mean stress of the step.
template <bool reduced>
void move_point(std::span<const IwanElement> elements, const LoopReduction& loops, double lame, double shear,
                const Points& points, std::size_t i) {
  constexpr std::size_t before = reduced ? reduced_entries : 0;
  const Step step = step_of(points, i);
  Relaxed by_group;
  double* const memory = points.state + i * (before + 3 * elements.size());
  double* const state = memory + before;
  for (std::size_t first = 0; first < elements.size(); first += iwan_group)
    move_group(&elements[first], step, state + 3 * first, by_group);
  Deviator relaxed = {sum(by_group.xx), sum(by_group.yy), sum(by_group.xy)};
  if constexpr (reduced)
    relaxed = relaxed_by_reduced(elements, loops, shear, step, points.dwxy[i], relaxed, state, memory);
  const auto [rxx, ryy, rxy] = relaxed;

  const InPlaneStress carried = rotated({points.sxx[i], points.syy[i], points.sxy[i]}, points.dwxy[i]);
  const double dezz = out_of_plane_strain(points, i);
  const double pressure = lame * (points.dexx[i] + points.deyy[i] + dezz);
  const double sxx = carried.xx + pressure + 2.0 * shear * points.dexx[i] - rxx;
  const double syy = carried.yy + pressure + 2.0 * shear * points.deyy[i] - ryy;
  const double szz = points.szz[i] + pressure + 2.0 * shear * dezz + rxx + ryy;
  const double sxy = carried.xy + shear * points.dgxy[i] - rxy;
  points.plastic_work[i] += 0.25 / shear *
                            ((carried.xx + sxx) * rxx + (carried.yy + syy) * ryy -
                             (points.szz[i] + szz) * (rxx + ryy) + 2.0 * (carried.xy + sxy) * rxy);
  points.sxx[i] = sxx;
  points.syy[i] = syy;
  points.szz[i] = szz;
  points.sxy[i] = sxy;
}

} // namespace

std::vector<IwanElement> parallel_elements(std::span<const CurveVertex> vertices) {
  std::vector<IwanElement> elements;
  double slope = vertices.front().stress / vertices.front().strain;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const CurveVertex& here = vertices[i];
    const bool last = i + 1 == vertices.size();
    const double next =
        last ? 0.0 : (vertices[i + 1].stress - here.stress) / (vertices[i + 1].strain - here.strain);
    elements.push_back({slope - next, (slope - next) * here.strain});
    slope = next;
  }
  return elements;
}

double monotonic_stress(std::span<const IwanElement> elements, double strain) {
  double stress = 0.0;
  for (const IwanElement& element : elements)
    stress += std::clamp(element.shear_modulus * strain, -element.strength, element.strength);
  return stress;
}

void update(const Elasticity& elastic, std::span<const IwanElement> elements, const LoopReduction& loops,
            const Points& points) {
  const double lame = elastic.lame();
  const double shear = elastic.shear_modulus();
  const auto move = loops.any() ? move_point<true> : move_point<false>;
  for (std::size_t i = 0; i < points.count; ++i)
    move(elements, loops, lame, shear, points, i);
}

std::span<const StateVariable> iwan_state_variables(std::size_t elements, const LoopReduction& loops) {
  static const Table table(false);
  static const Table reduced_table(true);
  if (loops.any())
    return std::span<const StateVariable>(reduced_table.variables).first(reduced_entries + 3 * elements);
  return std::span<const StateVariable>(table.variables).first(3 * elements);
}

void check_element_count(std::size_t count) {
  if (count < iwan_group || count > most_iwan_elements || count % iwan_group != 0) {
    throw std::invalid_argument(fmt::format("elements = {} must be a multiple of {} in [{}, {}]", count,
                                            iwan_group, iwan_group, most_iwan_elements));
  }
}

void validate(const Elasticity& elastic, std::span<const IwanElement> elements) {
  check(elastic);
  check_element_count(elements.size());
  double modulus = 0.0;
  for (const IwanElement& element : elements) {
    check_positive("shear modulus of an Iwan element", element.shear_modulus);
    check_positive("strength of an Iwan element", element.strength);
    modulus += element.shear_modulus;
  }
  const double wanted = elastic.shear_modulus();
  check_range("sum of the Iwan elements' shear moduli", modulus, (1.0 - 1e-9) * wanted,
              (1.0 + 1e-9) * wanted);
}

} // namespace tremolo::materials
