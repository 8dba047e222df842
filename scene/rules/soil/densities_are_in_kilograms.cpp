#include "scene/rules/rules.hpp"
#include "scene/soils/soil_report.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void densities_are_in_kilograms(const Case& scene, Findings& findings) {
  const auto check = [&findings](const std::string& path, double density) {
    if (const auto doubt = density_doubt(density))
      findings.add(path + ".density", *doubt);
  };
  if (!scene.boundary.has_shaking_table())
    check("halfspace", scene.halfspace.density);
  for (const Soil& soil : scene.soils)
    check("soil." + soil.name, materials::elasticity(soil.law).density);
  for (std::size_t i = 0; i < scene.profile.size(); ++i)
    if (!scene.profile[i].soil)
      check(fmt::format("profile[{}]", i), scene.profile[i].elastic.density);
}

} // namespace tremolo::scene
