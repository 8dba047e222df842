#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tremolo::scene {

void structures_slip(const Case& scene, Findings& findings) {
  constexpr double most = 2.0; // 63 degrees
  const auto check = [&](const std::string& path, double friction) {
    if (friction > most)
      findings.add(path, fmt::format("'friction' = {0:g} is more than soil has: the tangent of the angle of "
                                     "friction is meant; that of {0:g} degrees is {1:.3g}",
                                     friction, std::tan(friction * std::numbers::pi / 180.0)));
  };
  for (std::size_t i = 0; i < scene.structures.size(); ++i) {
    const Structure& structure = scene.structures[i];
    const std::string path = scene.structures[i].path;
    check(path + ".friction", structure.friction);
    for (const SoilContact& against : structure.against)
      if (against.friction != structure.friction)
        check(path + ".against", against.friction);
  }
  for (const Lining& lining : scene.linings)
    for (const SoilContact& against : lining.against)
      check(lining.path + ".friction", against.friction);
}

} // namespace tremolo::scene
