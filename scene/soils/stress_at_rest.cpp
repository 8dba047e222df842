#include "scene/soils/stress_at_rest.hpp"

#include "mesh/cell_size.hpp"
#include "scene/meeting_boxes.hpp"
#include "scene/soils/plausible.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace tremolo::scene {

namespace {

constexpr double largest_k0 = 20.0;

/// q/q_f of a law at rest; nothing without a failure line.
std::optional<double> mobilised(const materials::Law& law, double vertical_stress, double k0) {
  const auto lines = materials::strength_lines(law);
  const auto failure = std::ranges::find_if(
      lines, [](const auto& line) { return line.name == "failure" || line.name == "bounding"; });
  if (failure == lines.end())
    return std::nullopt;
  const double mean = materials::traits(law).in_plane ? (1.0 + k0) / 2.0 : (1.0 + 2.0 * k0) / 3.0;
  const double strength = failure->q_of_p(mean * vertical_stress);
  return strength > 0.0 ? std::abs(1.0 - k0) * vertical_stress / strength
                        : std::numeric_limits<double>::infinity();
}

/// K0 between one that the law holds and one that it does not.
double limit_between(const materials::Law& law, double vertical_stress, double held, double beyond) {
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (held + beyond);
    (*mobilised(law, vertical_stress, middle) > 1.0 ? beyond : held) = middle;
  }
  return held;
}

} // namespace

std::optional<RestLimits> rest_limits(const materials::Law& law, double vertical_stress) {
  const auto at = [&](double k0) { return mobilised(law, vertical_stress, k0); };
  if (!at(1.0))
    return std::nullopt;
  return RestLimits{*at(0.0) > 1.0 ? limit_between(law, vertical_stress, 1.0, 0.0) : 0.0,
                    *at(largest_k0) > 1.0 ? limit_between(law, vertical_stress, 1.0, largest_k0)
                                          : std::numeric_limits<double>::infinity()};
}

double mobilised_angle_deg(double k0) {
  return std::asin(std::abs(1.0 - k0) / (1.0 + k0)) * 180.0 / std::numbers::pi;
}

std::vector<RestingSoil> resting_soils(const Case& scene, const std::vector<GroundColumn>& columns,
                                       double above_bottom) {
  std::vector<RestingSoil> worst;
  for (const GroundColumn& ground : columns)
    for (const GroundPiece& piece : ground) {
      if (!piece.soil)
        continue;
      const materials::Law& law = scene.soils[*piece.soil].law;
      const double y = std::min(piece.bottom + above_bottom, 0.5 * (piece.bottom + piece.top));
      const double vertical = vertical_stress(scene, ground, y);
      const auto share = vertical > 0.0
                             ? mobilised(law, vertical, materials::elasticity(law).rest_coefficient())
                             : std::nullopt;
      if (!share)
        continue;
      const RestingSoil here{*piece.soil, y, vertical, *share,
                             materials::elasticity(law).at_rest.has_value()};
      const auto known = std::ranges::find_if(worst, [&](const RestingSoil& one) {
        return scene.soils[one.soil].name == scene.soils[here.soil].name;
      });
      if (known == worst.end())
        worst.push_back(here);
      else if (here.mobilised > known->mobilised)
        *known = here;
    }
  return worst;
}

std::vector<GroundColumn> columns_of_domain(const Case& scene) {
  const double inside = mesh::alignment_tolerance(scene.mesh.size);
  std::vector<double> places = {scene.mesh.box.x_min + inside, scene.mesh.box.x_max - inside};
  for (const Region& region : scene.regions)
    if (!region.polygon.empty()) {
      const Box box = box_of(region.polygon);
      places.push_back(0.5 * (box.x_min + box.x_max));
    }
  std::vector<GroundColumn> columns;
  for (const double x : places)
    columns.push_back(ground_of_domain(scene, x));
  return columns;
}

std::vector<GroundColumn> free_fields_at_rest(const Case& scene, std::optional<SourceModel> model) {
  const auto& [sides, left, right, base] = scene.boundary;
  std::vector<GroundColumn> columns;
  const auto add = [&](const FreeFieldModel& field, const LateralBoundary& side) {
    if (!model || field.model == *model)
      columns.push_back(ground_of_free_field(scene, side));
  };
  if (scene.boundary.has_lateral_fields()) {
    add(left.field, left);
    add(right.field, right);
  }
  if (scene.boundary.has_ground_below())
    add(base.field, left);
  return columns;
}

std::vector<GroundColumn> columns_at_rest(const Case& scene) {
  std::vector<GroundColumn> columns = columns_of_domain(scene);
  for (GroundColumn& column : free_fields_at_rest(scene))
    columns.push_back(std::move(column));
  return columns;
}

std::string rest_path(const Case& scene, const RestingSoil& resting) {
  return fmt::format("soil.{}{}", scene.soils[resting.soil].name,
                     resting.is_given ? ".rest_coefficient" : "");
}

std::string text(const Case& scene, const RestingSoil& resting) {
  const Soil& soil = scene.soils[resting.soil];
  const double k0 = materials::elasticity(soil.law).rest_coefficient();
  const RestLimits limits = *rest_limits(soil.law, resting.vertical_stress);
  return fmt::format(
      "K0 = {:.4g} asks for {:.3g} times the strength of soil '{}' at y = {:.4g} m, under {:.4g} "
      "kPa of vertical effective stress, and mobilises {:.3g} degrees of friction; the soil "
      "holds K0 from {:.6g} to {:.6g} there",
      k0, resting.mobilised, soil.name, resting.y, 1e-3 * resting.vertical_stress, mobilised_angle_deg(k0),
      limits.active, limits.passive);
}

std::string strength_doubt(const Case& scene, const RestingSoil& resting) {
  constexpr double far_beyond = 20.0; // of the strength
  for (const char* key : {"undrained_strength", "cohesion_peak", "cohesion"}) {
    const std::string path = fmt::format("soil.{}.{}", scene.soils[resting.soil].name, key);
    const auto given = std::ranges::find(scene.values, path, &ValueInForce::key);
    if (given == scene.values.end())
      continue;
    if (const auto doubts = unit_doubts({*given}); !doubts.empty())
      return "; " + doubts.front().second;
    if (resting.mobilised > far_beyond)
      return fmt::format("; '{0}' is in Pa: {1} kPa would be {1}e3", key, given->value);
  }
  return {};
}

} // namespace tremolo::scene
