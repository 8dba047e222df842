#include "scene/plan/layers.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tremolo::scene {

const std::vector<Layer>& layers(const Case& scene, const LateralBoundary& side) {
  return side.own_profile.empty() ? scene.profile : side.own_profile;
}

const std::vector<Layer>& layers(const Case& scene, const SourceProcess& source) {
  if (!source.profile)
    return scene.profile;
  return *source.profile == Side::left ? scene.boundary.left.own_profile : scene.boundary.right.own_profile;
}

double water_level(const Case& scene, const SourceProcess& source) {
  if (!source.profile)
    return scene.water->beside(Side::left, scene.surface_level);
  return *source.profile == Side::left ? scene.boundary.left.water_level : scene.boundary.right.water_level;
}

bool damped(const std::vector<Layer>& layers) {
  return std::ranges::any_of(layers, [](const Layer& layer) { return layer.damping > 0.0; });
}

double base_level(double surface, const std::vector<Layer>& layers) {
  for (const Layer& layer : layers)
    surface -= layer.thickness;
  return surface;
}

namespace {

constexpr double same_level = 1e-6; // m

/// Index of the layer that begins at a level under a surface, layers.size() if the half-space goes on from
/// there; empty within a layer.
std::optional<std::size_t> beginning_at(double level, double surface, const std::vector<Layer>& layers) {
  double top = surface;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (std::abs(level - top) <= same_level)
      return i;
    top -= layers[i].thickness;
  }
  return level <= top + same_level ? std::optional(layers.size()) : std::nullopt;
}

} // namespace

std::optional<materials::Elasticity> ground_below_base(const Case& scene) {
  if (!scene.boundary.has_ground_below())
    return std::nullopt;
  const auto below = [&](const LateralBoundary& side) -> std::optional<materials::Elasticity> {
    const std::vector<Layer>& own = layers(scene, side);
    const auto index = beginning_at(scene.mesh.box.y_min, side.surface, own);
    if (!index)
      return std::nullopt;
    if (*index == own.size())
      return scene.halfspace;
    return own[*index].soil ? std::nullopt : std::optional(own[*index].elastic);
  };
  const auto left = below(scene.boundary.left);
  const auto right = below(scene.boundary.right);
  const auto values = [](const materials::Elasticity& e) {
    return std::tuple(e.density, e.young, e.poisson);
  };
  return left && right && values(*left) == values(*right) ? left : std::nullopt;
}

std::vector<double> with_interfaces(std::vector<double> levels, double surface,
                                    const std::vector<Layer>& layers, double close) {
  double interface = surface;
  for (const Layer& layer : layers) {
    interface -= layer.thickness;
    if (interface <= levels.front())
      break;
    std::erase_if(levels, [&](double level) {
      return std::abs(level - interface) <= close && level != levels.front() && level != levels.back();
    });
    levels.insert(std::ranges::lower_bound(levels, interface), 2, interface);
  }
  return levels;
}

} // namespace tremolo::scene
