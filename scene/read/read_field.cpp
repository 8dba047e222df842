#include "scene/read/read.hpp"
#include "scene/read/soil/read_water.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

void read_damping(Document& document, Case& scene) {
  const auto table = document.table("damping");
  using enum DampingModel;
  scene.damping.model = table.choice<DampingModel>("model");
  scene.damping.ratio = table.number("ratio");
  if (const auto f = table.numbers("frequencies"); f.size() == 2)
    scene.damping.frequencies = {f[0], f[1]};
  scene.damping.reference_hz = table.optional_number("reference_hz");
  if (const auto band = table.numbers("band"); band.size() == 2) {
    scene.damping.band.lowest_hz = band[0];
    scene.damping.band.highest_hz = band[1];
  }
  if (table.given("mechanisms"))
    scene.damping.band.mechanisms = table.integer("mechanisms");
}

/// Constants of the named soil, or of the layer itself.
void read_layer_soil(const TableReader& table, Findings& findings, const Case& scene, Layer& layer) {
  const auto soil = table.text("soil");
  if (soil.empty()) {
    if (!table.given("density"))
      findings.add(table.path("density"),
                   "missing 'density': a layer without 'soil' has constants of its own");
    layer.elastic = read_elasticity(table, findings);
    return;
  }
  for (const char* key : {"density", "young", "poisson", "vs", "vp", "damping"})
    if (table.given(key))
      findings.add(table.path(key), fmt::format("'{}' and 'soil' exclude each other: remove one", key));
  layer.soil = soil_index(table, scene.soils, findings);
  if (layer.soil)
    layer.elastic = materials::elasticity(scene.soils[*layer.soil].law);
}

} // namespace

std::vector<Layer> read_layers(Document& document, const char* name, Findings& findings, const Case& scene) {
  std::vector<Layer> layers;
  for (const auto& table : document.array(name)) {
    Layer layer;
    layer.thickness = table.number("thickness");
    read_layer_soil(table, findings, scene, layer);
    layer.damping = layer.soil ? scene.soils[*layer.soil].damping
                               : table.optional_number("damping").value_or(scene.damping.ratio);
    layers.push_back(layer);
  }
  return layers;
}

namespace {

/// Surface and half-space, which a free field needs and a shaking table has not.
void read_ends_of_ground(Document& document, Findings& findings, Case& scene) {
  for (const auto& [name, what] : {std::pair("surface", "the free surface of the free field"),
                                   std::pair("halfspace", "the half-space below the free field")})
    if (scene.boundary.has_ground_below() && !document.has(name))
      findings.add(name,
                   fmt::format("missing table [{}]: {}, unless the base is a shaking table", name, what));
  if (document.has("surface"))
    scene.surface_level = document.table("surface").number("level");
  if (!document.has("halfspace"))
    return;
  const auto half_space = document.table("halfspace");
  scene.halfspace = read_elasticity(half_space, findings);
  scene.halfspace_damping = half_space.number("damping");
}

/// After the tables have been read, so that their places are known.
void refuse_ground_below_table(const Document& document, Findings& findings) {
  for (const char* name : {"surface", "halfspace", "profile"})
    if (document.has(name))
      findings.add(name,
                   fmt::format("[{}] is ground of a free field, which a shaking table does not stand on; "
                               "remove it",
                               name));
}

} // namespace

void read_free_field(Document& document, Findings& findings, Case& scene) {
  read_motion(document, findings, scene);
  read_ends_of_ground(document, findings, scene);
  read_damping(document, scene);
  read_water(document, findings, scene);
  if (document.has("soil"))
    read_soils(document, findings, scene);
  scene.profile = read_layers(document, "profile", findings, scene);
  read_random_profile(document, findings, scene);
  scene.profile = watered_profile(scene);
  read_numerics(document, scene);
  if (!scene.boundary.has_ground_below())
    refuse_ground_below_table(document, findings);
}

} // namespace tremolo::scene
