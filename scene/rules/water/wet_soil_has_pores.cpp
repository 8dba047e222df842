#include "scene/plan/wet_soils.hpp"
#include "scene/read/soil/read_water.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void wet_soil_has_pores(const Case& scene, Findings& findings) {
  if (!scene.water || !findings.sound("water"))
    return;
  const std::string place =
      scene.water->is_level() ? fmt::format("y = {} m", scene.water->level) : table_text(*scene.water);
  for (const Soil& soil : soils_below_table(scene)) {
    const auto path = "soil." + soil.name;
    if (!findings.sound(path) || !pores_are_sound(path, findings))
      continue;
    if (!soil.pores)
      findings.add(
          path, fmt::format("missing 'porosity' or 'void_ratio': soil '{}' lies below the water table, {}, "
                            "and its pores are full of water",
                            soil.name, place));
    else if (soil.pores->drainage == materials::Drainage::coupled && !(soil.pores->permeability > 0.0))
      findings.add(path,
                   fmt::format("missing 'permeability', m/s: soil '{}' lies below the water table, {}, "
                               "and water flows in it; give the hydraulic conductivity (sand 1e-5 to 1e-3 "
                               "m/s), or drainage = \"undrained\" or \"drained\"",
                               soil.name, place));
  }
}

} // namespace tremolo::scene
