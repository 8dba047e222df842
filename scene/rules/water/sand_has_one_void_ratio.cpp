#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::scene {

void sand_has_one_void_ratio(const Case& scene, Findings& findings) {
  constexpr double same = 0.005;
  for (const Soil& soil : scene.soils)
    if (soil.pores && soil.law_void_ratio && std::abs(soil.pores->void_ratio() - *soil.law_void_ratio) > same)
      findings.add(
          "soil." + soil.name,
          fmt::format("soil '{}': water and weight take the void ratio {:.4g} that is given, the law "
                      "takes {:.4g} of its 'relative_density', 'e_max' and 'e_min'; both are the same "
                      "without 'porosity' and 'void_ratio'",
                      soil.name, soil.pores->void_ratio(), *soil.law_void_ratio));
}

} // namespace tremolo::scene
