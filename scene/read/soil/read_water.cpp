#include "scene/read/soil/read_water.hpp"

#include "scene/soils/plausible.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tremolo::scene {

namespace {

constexpr std::array pore_key_names = {"porosity", "void_ratio", "grain_density", "permeability", "drainage"};

constexpr double quartz = 2650.0; // kg/m3

/// Tolerance of a given density relative to that of grains and water, since tables of soils round it.
constexpr double density_rounding = 0.002;

/// Keys of pores in a case without water would have no effect.
void refuse_dry(const TableReader& table, Findings& findings) {
  for (const char* key : pore_key_names)
    if (table.given(key))
      findings.add(table.path(key),
                   fmt::format("'{}' is of soil below a water table, but the case has none: add [water] with "
                               "its level, or remove '{}'",
                               key, key));
}

/// A line that is level is a table, and between equal levels nothing flows.
void rest_if_level(GroundWater& water) {
  if (std::ranges::all_of(water.line, [&](const Point& corner) { return corner.y == water.level; }))
    water.line.clear();
  if (water.seepage && water.seepage->left == water.seepage->right)
    water.seepage.reset();
}

/// A case says once where its water is.
void refuse_two_tables(const TableReader& table, Findings& findings) {
  const bool seeps = table.boolean("seepage");
  if (seeps) {
    for (const char* key : {"level", "line"})
      if (table.given(key))
        findings.add(
            table.path(key),
            fmt::format("'{}' is of water at rest, and with seepage = true it flows between 'left' and "
                        "'right': remove '{}', or seepage",
                        key, key));
  } else if (table.given("level") && table.given("line")) {
    findings.add(table.path("line"), "'line' and 'level' exclude each other: remove one");
  } else if (!table.given("level") && !table.given("line")) {
    findings.add(table.path(),
                 "missing 'level', y of the water table in m; or 'line', or seepage = true with "
                 "'left' and 'right'");
  }
}

/// Porosity as the soil gives it, otherwise as its law has it; nothing if neither does.
std::optional<double> porosity(const TableReader& table, const GroundWater& water, double grains) {
  if (const auto n = table.optional_number("porosity"))
    return n;
  if (const auto e = table.optional_number("void_ratio"))
    return materials::porosity_of(*e);
  if (const auto e = void_ratio_of_law(table))
    return materials::porosity_of(*e);
  if (const auto density = saturated_density_of_law(table))
    return (grains - *density) / (grains - water.fluid.density);
  return std::nullopt;
}

/// Whether the density in the file is that of the saturated soil; gives the soil this density.
void settle_density(TableReader& table, const materials::PoreSpace& pores, const GroundWater& water,
                    Findings& findings) {
  const double saturated = materials::saturated_density(pores, water.fluid);
  const auto given = table.optional_number("density");
  if (given && std::abs(*given - saturated) > density_rounding * saturated) {
    const auto doubt = unit_doubt(table.path("density"), *given);
    findings.add(table.path("density"),
                 fmt::format("'density' = {} contradicts porosity {:.4g} and grains of {:g} kg/m3, which "
                             "make {:.5g} kg/m3 saturated and {:.5g} kg/m3 dry; of soil with pores the "
                             "saturated density is meant: remove 'density', or mend the others{}",
                             *given, pores.porosity, pores.grain_density, saturated,
                             materials::dry_density(pores), doubt ? "; " + *doubt : ""));
    return;
  }
  table.settle("density", saturated, "porosity and grain density, saturated");
}

} // namespace

GroundWater read_levels(const TableReader& table, Findings& findings) {
  GroundWater water;
  if (table.boolean("seepage"))
    water.seepage = {table.number("left"), table.number("right")};
  else if (table.given("line"))
    water.line = table.polygon("line");
  else
    water.level = table.number("level");
  if (!water.is_level())
    water.level = water.beside(Side::left);
  rest_if_level(water);
  refuse_two_tables(table, findings);
  return water;
}

namespace {

/// A load that water has time to leave comes after a change of the water that it has not.
void refuse_drained_loads(const Case& scene, std::size_t first, std::size_t end, Findings& findings) {
  for (std::size_t l = first; l < end; ++l)
    if (const LoadStage& load = scene.loads[l]; !load.undrained || !load.drainage.empty())
      findings.add(load.path + ".drainage",
                   fmt::format("the load '{}' is drained, and soil above the water has not drained since an "
                               "undrained stage before it: make all of the load undrained, or let a drained "
                               "stage of kind \"water\" or \"construction\" come between",
                               load.name));
}

/// Follows the water through the stages.
void follow_stages(Case& scene, Findings& findings) {
  for (std::size_t c = 0; c < scene.constructions.size(); ++c) {
    ConstructionStage& stage = scene.constructions[c];
    stage.before.water = scene.water;
    std::optional<double> still_wet = stage.undrained ? scene.water->still_wet : std::nullopt;
    if (still_wet && !stage.drainage.empty())
      findings.add(stage.path + ".drainage",
                   fmt::format("soil above the water has not drained since an undrained stage before '{}', "
                               "and stays wet in all soils or in none: give \"undrained\" or \"drained\"",
                               stage.name));
    if (stage.undrained && stage.water) {
      if (!stage.water->is_level() || !scene.water->is_level())
        findings.add(
            stage.path + ".drainage",
            "water can change without flowing from one level to another alone, not to or from a 'line' or "
            "seepage: leave drainage out");
      still_wet = scene.water->highest();
    }
    if (stage.water) {
      const materials::PoreFluid fluid = scene.water->fluid;
      scene.water = stage.water;
      scene.water->fluid = fluid;
    }
    scene.water->still_wet = still_wet;
    const std::size_t end =
        c + 1 < scene.constructions.size() ? scene.constructions[c + 1].loads_before : scene.loads.size();
    if (still_wet)
      refuse_drained_loads(scene, stage.loads_before, end, findings);
  }
}

} // namespace

void read_water(Document& document, Findings& findings, Case& scene) {
  if (!document.has("water")) {
    for (const ConstructionStage& stage : scene.constructions)
      if (stage.water)
        findings.add(stage.path + ".kind",
                     "a stage of kind \"water\" changes [water], which the case does not "
                     "have: add it");
    return;
  }
  const auto table = document.table("water");
  scene.water = read_levels(table, findings);
  scene.water->fluid = {.density = table.number("density"),
                        .bulk_modulus = table.number("bulk_modulus"),
                        .cavitation_pressure = table.number("cavitation_pressure")};
  follow_stages(scene, findings);
}

std::optional<materials::PoreSpace> read_pores(TableReader& table, const std::optional<GroundWater>& water,
                                               Findings& findings) {
  if (!water) {
    refuse_dry(table, findings);
    return std::nullopt;
  }
  if (table.given("porosity") && table.given("void_ratio"))
    findings.add(table.path("void_ratio"), "'void_ratio' and 'porosity' exclude each other: remove one");
  if (!pores_are_sound(table.path(), findings)) {
    if (!table.given("density"))
      table.settle("density", quartz, "unknown"); // the case is refused for its pores, not for its density
    return std::nullopt;
  }
  const double grains = table.optional_number("grain_density").value_or(quartz);
  const auto n = porosity(table, *water, grains);
  if (!n)
    return std::nullopt;
  if (!(*n >= 0.01 && *n <= 0.95)) {
    findings.add(table.path("density"),
                 fmt::format("a saturated density with grains of {:g} kg/m3 makes the porosity {:.4g}, must "
                             "be in [0.01, 0.95]; give 'porosity'",
                             grains, *n));
    return std::nullopt;
  }
  const materials::PoreSpace pores{.porosity = *n,
                                   .grain_density = grains,
                                   .permeability = table.number("permeability"),
                                   .drainage = table.choice<materials::Drainage>("drainage")};
  settle_density(table, pores, *water, findings);
  return pores;
}

bool pores_are_sound(const std::string& soil, const Findings& findings) {
  const auto sound = [&](const char* key) { return findings.sound(fmt::format("{}.{}", soil, key)); };
  // The void ratio of sand follows from the keys of its law.
  return findings.sound("water.density") && std::ranges::all_of(pore_key_names, sound) &&
         std::ranges::all_of(std::array{"relative_density", "e_max", "e_min"}, sound);
}

std::vector<Layer> watered(const std::vector<Layer>& layers, double surface, double level,
                           const Case& scene) {
  if (!scene.water)
    return layers;
  std::vector<Layer> cut;
  double top = surface;
  for (const Layer& layer : layers) {
    const double bottom = top - layer.thickness;
    const Soil* soil = layer.soil ? &scene.soils[*layer.soil] : nullptr;
    if (soil == nullptr || !soil->pores) {
      cut.push_back(layer);
    } else {
      const double table = std::clamp(level, bottom, top);
      const auto& skeleton = materials::elasticity(soil->law);
      if (table < top) {
        Layer& above = cut.emplace_back(layer);
        above.thickness = top - table;
        above.elastic = materials::dry(skeleton, *soil->pores);
        above.wet = false;
      }
      if (table > bottom) {
        Layer& below = cut.emplace_back(layer);
        below.thickness = table - bottom;
        below.elastic = materials::saturated(skeleton, *soil->pores, scene.water->fluid);
        below.wet = true;
      }
    }
    top = bottom;
  }
  return cut;
}

std::vector<Layer> watered_profile(const Case& scene) {
  const double surface = scene.surface_level;
  return watered(scene.profile, surface, scene.water ? scene.water->beside(Side::left, surface) : 0.0, scene);
}

std::vector<Layer> watered(const std::vector<Layer>& layers, const LateralBoundary& side, const Case& scene) {
  return watered(layers, side.surface, side.water_level, scene);
}

} // namespace tremolo::scene
