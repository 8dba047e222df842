#include "materials/hysteretic/multi_yield_clay.hpp"

#include "materials/elastic/elastic_parameters.hpp"
#include "materials/hysteretic/backbone/backbone_polygon.hpp"
#include "materials/law/parameter_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>

namespace tremolo::materials {
namespace {

constexpr std::array given = {Parameter{.name = "undrained_strength",
                                        .unit = "Pa",
                                        .meaning = "undrained shear strength s_u",
                                        .range = above_zero},
                              Parameter{.name = "peak_strain",
                                        .unit = "1",
                                        .meaning = "engineering shear strain at which s_u is reached",
                                        .range = {.low = 1e-6, .high = 1.0},
                                        .fallback = "0.1"},
                              Parameter{.name = "surfaces",
                                        .unit = "1",
                                        .meaning = "number of nested yield surfaces",
                                        .range = {.low = iwan_group, .high = most_iwan_elements},
                                        .otherwise = "20",
                                        .remark = "a multiple of 4",
                                        .whole = true}};

void check_strength(const Elasticity& elastic, double undrained_strength, double peak_strain) {
  check(elastic);
  check(given[0], undrained_strength);
  check(given[1], peak_strain);
  const double elastic_stress = elastic.shear_modulus() * peak_strain;
  if (!(undrained_strength < elastic_stress)) {
    throw std::invalid_argument(fmt::format(
        "undrained_strength = {:g} Pa must be below shear modulus times peak_strain, {:g} Pa: it is not "
        "reached at this strain even elastically",
        undrained_strength, elastic_stress));
  }
}

/// The polygon up to the strain at which it reaches `strength`.
std::vector<CurveVertex> cut_at(std::vector<CurveVertex> vertices, double strength) {
  const auto reached = std::find_if(vertices.begin(), vertices.end(),
                                    [&](const CurveVertex& vertex) { return vertex.stress >= strength; });
  if (reached != vertices.end()) {
    const CurveVertex from = reached == vertices.begin() ? CurveVertex{} : *(reached - 1);
    const double part = (strength - from.stress) / (reached->stress - from.stress);
    *reached = {from.strain + part * (reached->strain - from.strain), strength};
    vertices.erase(reached + 1, vertices.end());
  }
  return vertices;
}

/// Elements of the polygon; the last one is halved until their number is a multiple of iwan_group.
std::vector<IwanElement> surfaces_of(const std::vector<CurveVertex>& vertices) {
  std::vector<IwanElement> elements = parallel_elements(vertices);
  while (elements.size() % iwan_group != 0) {
    elements.back() = {0.5 * elements.back().shear_modulus, 0.5 * elements.back().strength};
    elements.push_back(elements.back());
  }
  return elements;
}

/// Vertices at the points of a table from the last one on tau = G gamma, or from where the line of its first
/// two points meets it: the curve starts with G and passes through every point.
std::vector<CurveVertex> vertices_of(double shear_modulus, const SoilCurves& curves) {
  const auto& ratio = curves.modulus_ratio;
  std::size_t first_vertex = 0;
  while (first_vertex + 1 < ratio.size() && ratio[first_vertex + 1] == 1.0)
    ++first_vertex;
  std::vector<CurveVertex> vertices;
  for (std::size_t k = first_vertex; k < ratio.size(); ++k)
    vertices.push_back({curves.strain[k], shear_modulus * ratio[k] * curves.strain[k]});
  if (vertices.size() >= 2 && ratio[first_vertex] < 1.0) {
    const CurveVertex& first = vertices.front();
    const double slope = (vertices[1].stress - first.stress) / (vertices[1].strain - first.strain);
    const double strain = (first.stress - slope * first.strain) / (shear_modulus - slope);
    vertices.front() = {strain, shear_modulus * strain};
  }
  return vertices;
}

void check_concave(std::span<const CurveVertex> vertices, double shear_modulus) {
  double slope = shear_modulus;
  for (std::size_t k = 1; k < vertices.size(); ++k) {
    const double next =
        (vertices[k].stress - vertices[k - 1].stress) / (vertices[k].strain - vertices[k - 1].strain);
    if (!(next > 0.0 && next < slope)) {
      throw std::invalid_argument(fmt::format(
          "modulus reduction curve: from strain {:g} to {:g} the stress grows by {:g} Pa per unit strain, "
          "which must be positive and below the {:g} Pa before; leave points out, or check "
          "undrained_strength "
          "and peak_strain",
          vertices[k - 1].strain, vertices[k].strain, next, slope));
    }
    slope = next;
  }
}

/// Strain at which monotonic loading reaches a stress below the strength.
double strain_at(std::span<const IwanElement> elements, double shear_modulus, double wanted) {
  double strain = 0.0;
  double stress = 0.0;
  double slope = shear_modulus;
  for (const IwanElement& element : elements) {
    const double yield = element.strength / element.shear_modulus;
    if (stress + slope * (yield - strain) >= wanted)
      return strain + (wanted - stress) / slope;
    stress += slope * (yield - strain);
    strain = yield;
    slope -= element.shear_modulus;
  }
  return strain;
}

} // namespace

MultiYieldClay multi_yield_clay(const Elasticity& elastic, double undrained_strength,
                                const ClaySurfaces& surfaces) {
  check_strength(elastic, undrained_strength, surfaces.peak_strain);
  check_element_count(surfaces.count);
  const double shear = elastic.shear_modulus();
  const double peak = surfaces.peak_strain;
  const double reference = peak * undrained_strength / (shear * peak - undrained_strength);
  const Backbone hyperbola = {shear, reference, 1.0, 1.0};
  return {elastic, undrained_strength, peak,
          surfaces_of(cut_at(polygon(hyperbola, surfaces.count, peak), undrained_strength))};
}

MultiYieldClay multi_yield_clay(const Elasticity& elastic, double undrained_strength,
                                const SoilCurves& curves, double peak_strain) {
  check_strength(elastic, undrained_strength, peak_strain);
  validate(curves);
  std::vector<CurveVertex> vertices =
      cut_at(vertices_of(elastic.shear_modulus(), curves), undrained_strength);
  if (vertices.back().stress < undrained_strength) {
    if (!(vertices.back().strain < peak_strain)) {
      throw std::invalid_argument(
          fmt::format("modulus reduction curve: its stress at strain {:g} is {:g} Pa, "
                      "below undrained_strength = {:g} Pa, and peak_strain = {:g} is "
                      "not beyond it",
                      vertices.back().strain, vertices.back().stress, undrained_strength, peak_strain));
    }
    vertices.push_back({peak_strain, undrained_strength});
  }
  check_concave(vertices, elastic.shear_modulus());
  MultiYieldClay law{elastic, undrained_strength, peak_strain, surfaces_of(vertices)};
  check_element_count(law.elements.size());
  return law;
}

double monotonic_stress(const MultiYieldClay& law, double strain) {
  return monotonic_stress(std::span(law.elements), strain);
}

void initialise(const MultiYieldClay& law, const Points& points) {
  const std::size_t count = law.elements.size();
  for (std::size_t i = 0; i < points.count; ++i) {
    const double mean = (points.sxx[i] + points.syy[i] + points.szz[i]) / 3.0;
    const double xx = points.sxx[i] - mean;
    const double yy = points.syy[i] - mean;
    const double xy = points.sxy[i];
    const double shear_stress = std::sqrt(xx * xx + yy * yy + xx * yy + xy * xy);
    const double strain = strain_at(law.elements, law.elastic.shear_modulus(), shear_stress);
    double* const state = points.state + i * 3 * count;
    for (std::size_t k = 0; k < count; ++k) {
      const IwanElement& element = law.elements[k];
      const double part = shear_stress > 0.0
                              ? std::min(element.shear_modulus * strain, element.strength) / shear_stress
                              : 0.0;
      double* const s = state + 3 * (k - k % iwan_group) + k % iwan_group;
      s[0] = part * xx;
      s[iwan_group] = part * yy;
      s[2 * iwan_group] = part * xy;
    }
    if (shear_stress > law.undrained_strength) {
      const double kept = law.undrained_strength / shear_stress;
      points.sxx[i] = mean + kept * xx;
      points.syy[i] = mean + kept * yy;
      points.szz[i] = mean - kept * (xx + yy);
      points.sxy[i] = kept * xy;
    }
  }
}

Traits traits(const MultiYieldClay& /*law*/) {
  return {.name = "multi_yield_clay",
          .response = Response::hysteretic,
          .remembers_initial_stress = true,
          .total_stress = true,
          .unlimited_tension = true};
}

std::span<const StateVariable> state_variables(const MultiYieldClay& law) {
  return iwan_state_variables(law.elements.size(), {});
}

std::vector<StrengthLine> strength_lines(const MultiYieldClay& law) {
  return {{"failure",
           [strength = law.undrained_strength](double /*p*/) { return std::numbers::sqrt3 * strength; }}};
}

LinearElastic without_softening(const MultiYieldClay& law) {
  return {law.elastic};
}

std::optional<DruckerPrager> with_reduced_strength(const MultiYieldClay& law, double factor) {
  return frictionless(law.elastic, law.undrained_strength / factor);
}

void update(const MultiYieldClay& law, const Points& points) {
  update(law.elastic, law.elements, {}, points);
}

void validate(const MultiYieldClay& law) {
  check_strength(law.elastic, law.undrained_strength, law.peak_strain);
  validate(law.elastic, law.elements);
  double strength = 0.0;
  for (const IwanElement& element : law.elements)
    strength += element.strength;
  check_range("sum of the elements' strengths", strength, (1.0 - 1e-9) * law.undrained_strength,
              (1.0 + 1e-9) * law.undrained_strength);
}

std::span<const Parameter> multi_yield_clay_parameters() {
  return given;
}

std::vector<ParameterValue> parameters(const MultiYieldClay& law) {
  std::vector<ParameterValue> values = elastic_parameters(law.elastic);
  values.push_back(report(given[0], law.undrained_strength));
  values.push_back(report(given[1], law.peak_strain));
  values.push_back(report(given[2], static_cast<double>(law.elements.size())));
  return values;
}

} // namespace tremolo::materials
