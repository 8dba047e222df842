#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

constexpr double lightest = 10.0;  // kg/m3: foam
constexpr double heaviest = 2.0e4; // kg/m3: lead has 11,340

} // namespace

void structures_weigh_what_they_can(const Case& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.structures.size(); ++i) {
    const double density = scene.structures[i].density;
    if (density >= lightest && density <= heaviest)
      continue;
    const bool light = density < lightest;
    findings.add(fmt::format("structure[{}].density", i),
                 fmt::format("'density' = {:g} kg/m3 is that of no structure: kg/m3 are meant, 2400 for "
                             "concrete, about 300 for a building with its rooms; {:g} {} would be {:.4g}",
                             density, density, light ? "t/m3" : "N/m3",
                             light ? 1e3 * density : density / 9.81));
  }
}

} // namespace tremolo::scene
