#include "mesh/cell_size.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/rules/rules.hpp"
#include "scene/soils/ground_column.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <set>
#include <tuple>

namespace tremolo::scene {

namespace {

constexpr double same = 0.01; // relative

bool near(double a, double b) {
  return std::abs(a - b) <= same * std::max(std::abs(a), std::abs(b));
}

bool alike(const materials::Elasticity& a, const materials::Elasticity& b) {
  return near(a.density, b.density) && near(a.young, b.young) &&
         near(1.0 - 2.0 * a.poisson, 1.0 - 2.0 * b.poisson);
}

/// Whether a soil is as good as another: the same law with the same parameters, or, where one law is a
/// simpler one, the same waves at small strain.
bool alike(const Soil& a, const Soil& b) {
  if (materials::name(a.law) != materials::name(b.law))
    return alike(materials::elasticity(a.law), materials::elasticity(b.law));
  return std::ranges::equal(materials::parameters(a.law), materials::parameters(b.law),
                            [](const auto& one, const auto& other) { return near(one.value, other.value); });
}

/// Whether a layer without a soil has the constants of a soil: its skeleton's, or those with and without
/// water in the pores.
bool alike(const Soil& soil, const materials::Elasticity& layer, const Case& scene) {
  const materials::Elasticity& skeleton = materials::elasticity(soil.law);
  return alike(skeleton, layer) ||
         (soil.pores && (alike(materials::dry(skeleton, *soil.pores), layer) ||
                         alike(materials::saturated(skeleton, *soil.pores, scene.water->fluid), layer)));
}

bool alike(const GroundPiece& domain, const GroundPiece& field, const Case& scene) {
  const Soil& soil = scene.soils[*domain.soil];
  if (!field.soil)
    return alike(soil, field.elastic, scene);
  return domain.soil == field.soil || alike(soil, scene.soils[*field.soil]);
}

const GroundPiece* piece_at(const GroundColumn& ground, double y) {
  const auto piece =
      std::ranges::find_if(ground, [y](const GroundPiece& p) { return p.bottom < y && y < p.top; });
  return piece == ground.end() ? nullptr : &*piece;
}

std::string name_of(const GroundPiece& piece, const Case& scene) {
  return piece.soil ? fmt::format("'{}'", scene.soils[*piece.soil].name)
                    : fmt::format("elastic ground of {:.4g} m/s", piece.elastic.s_wave_speed());
}

/// A text on the depths at which the free field of a side has other ground than the domain at x, from the top
/// down.
std::vector<std::string> differences(const Case& scene, const LateralBoundary& side, double x) {
  const GroundColumn domain = ground_of_domain(scene, x);
  const GroundColumn field = ground_of_free_field(scene, side);
  std::set<double, std::greater<>> levels;
  for (const GroundColumn* ground : {&domain, &field})
    for (const GroundPiece& piece : *ground)
      levels.insert({piece.top, piece.bottom});
  // Layers thinner than a particle are not resolved.
  const double thin = 0.5 * scene.mesh.particle_size();
  std::vector<std::string> found;
  double begin = 0.0;
  std::string last;
  const auto close = [&](double y) {
    if (!last.empty() && begin - y > thin)
      found.push_back(
          fmt::format("from {:.4g} to {:.4g} m depth (y = {:.4g} to {:.4g} m) the free field has {}",
                      side.surface - begin, side.surface - y, begin, y, last));
  };
  for (auto top = levels.begin(); top != levels.end() && std::next(top) != levels.end(); ++top) {
    const double middle = 0.5 * (*top + *std::next(top));
    const GroundPiece* inside = piece_at(domain, middle);
    const GroundPiece* beside = piece_at(field, middle);
    std::string now;
    if (inside != nullptr && beside != nullptr && !alike(*inside, *beside, scene))
      now = fmt::format("{}, the domain {}", name_of(*beside, scene), name_of(*inside, scene));
    if (now == last)
      continue;
    close(*top);
    begin = *top;
    last = now;
  }
  if (!levels.empty())
    close(*levels.rbegin());
  return found;
}

} // namespace

void profile_is_that_of_side(const Case& scene, Findings& findings) {
  if (!scene.boundary.has_lateral_fields())
    return;
  const double inside = mesh::alignment_tolerance(scene.mesh.size);
  for (const auto& [side, name, x] :
       {std::tuple(&scene.boundary.left, "left", scene.mesh.box.x_min + inside),
        std::tuple(&scene.boundary.right, "right", scene.mesh.box.x_max - inside)}) {
    const SourceModel model = side->field.model;
    if (layers(scene, *side).empty() || !traits(model).computed)
      continue;
    const auto found = differences(scene, *side, x);
    if (!found.empty())
      findings.add(side->own_profile.empty() ? "profile[0]" : fmt::format("boundary.{}.profile[0]", name),
                   fmt::format("the layers differ from the regions at the {} side: {}; the free field moves "
                               "the side as another ground does",
                               name, fmt::join(found, "; ")));
  }
}

} // namespace tremolo::scene
