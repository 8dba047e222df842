#include "app/verify/exact_field.hpp"

#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

namespace tremolo::app {
namespace {

/// Relative difference up to which two densities, stiffnesses or areas are the same.
constexpr double same_within = 1e-6;

bool same(double a, double b) {
  return std::abs(a - b) <= same_within * std::abs(b);
}

std::optional<std::string> surfaces_differ(const scene::Case& scene) {
  const double left = scene.boundary.left.surface;
  const double right = scene.boundary.right.surface;
  if (left != right)
    return fmt::format("the free fields have their surfaces at different levels, y = {} m on the left and y "
                       "= {} m on the right",
                       left, right);
  if (left != scene.surface_level)
    return fmt::format(
        "the free surface of both sides, y = {} m, is not the [surface] level, y = {} m, of the wave", left,
        scene.surface_level);
  return std::nullopt;
}

std::optional<std::string> layered(const scene::Case& scene) {
  if (scene.profile.empty())
    return std::nullopt;
  return fmt::format("the free field is layered: [[profile]] has {} layers", scene.profile.size());
}

std::optional<std::string> differs_from_half_space(const scene::Soil& soil,
                                                   const materials::Elasticity& deep) {
  if (materials::traits(soil.law).response != materials::Response::elastic)
    return fmt::format("soil '{}' is not linear elastic but {}", soil.name, materials::name(soil.law));
  const materials::Elasticity& e = materials::elasticity(soil.law);
  if (same(e.density, deep.density) && same(e.shear_modulus(), deep.shear_modulus()) &&
      same(e.p_modulus(), deep.p_modulus()))
    return std::nullopt;
  return fmt::format(
      "soil '{}' (density {:g} kg/m3, young {:g} Pa, poisson {:g}) differs from the half-space "
      "({:g} kg/m3, {:g} Pa, {:g})",
      soil.name, e.density, e.young, e.poisson, deep.density, deep.young, deep.poisson);
}

std::optional<std::string> heterogeneous(const scene::Case& scene) {
  for (const scene::Region& region : scene.regions)
    for (const std::size_t soil : scene::soils_of(region))
      if (auto why = differs_from_half_space(scene.soils[soil], scene.halfspace))
        return why;
  return std::nullopt;
}

std::optional<std::string> built_on(const scene::Case& scene) {
  if (scene.structures.empty())
    return std::nullopt;
  return fmt::format("structure '{}' scatters the waves", scene.structures.front().name);
}

/// Regions lie in the box and do not overlap: they fill it up to the surface where their areas do.
std::optional<std::string> uneven(const scene::Case& scene) {
  const double level = scene.surface_level;
  double filled = 0.0;
  for (const scene::Region& region : scene.regions) {
    filled += scene::area(region.polygon);
    for (const scene::Point corner : region.polygon)
      if (corner.y > level)
        return fmt::format(
            "the ground is not level: soil at ({}, {}) m lies above the free surface, y = {} m", corner.x,
            corner.y, level);
  }
  const double whole = scene.mesh.box.width() * (level - scene.mesh.box.y_min);
  if (same(filled, whole))
    return std::nullopt;
  return fmt::format("the ground is not level: the soil fills {:g} m2 of the {:g} m2 below the free surface",
                     filled, whole);
}

} // namespace

std::optional<std::string> why_not_exact(const scene::Case& scene) {
  for (const auto reason : {surfaces_differ, layered, heterogeneous, built_on, uneven})
    if (auto why = reason(scene))
      return why;
  return std::nullopt;
}

} // namespace tremolo::app
