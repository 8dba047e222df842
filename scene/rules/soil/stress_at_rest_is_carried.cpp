#include "scene/rules/rules.hpp"
#include "scene/soils/stress_at_rest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace tremolo::scene {

namespace {

bool ground_is_sound(const Case& scene, const Findings& findings) {
  for (std::size_t i = 0; i < scene.regions.size(); ++i)
    for (const char* key : {"soil", "polygon"})
      if (!findings.sound(fmt::format("{}.{}", scene.regions[i].path, key)))
        return false;
  return scene.gravity && !scene.soils.empty() &&
         std::ranges::all_of(std::array{"region", "profile", "surface", "water", "stage"},
                             [&](const char* table) { return findings.sound(table); });
}

} // namespace

void stress_at_rest_is_carried(const Case& scene, Findings& findings) {
  if (!ground_is_sound(scene, findings))
    return;
  const auto refuse = [&](const RestingSoil& resting, const std::string& why) {
    const std::string path = rest_path(scene, resting);
    if (resting.is_beyond() && findings.sound(path))
      findings.add(path, why + strength_doubt(scene, resting));
  };
  for (const RestingSoil& resting : resting_soils(scene, columns_at_rest(scene)))
    if (resting.is_given)
      refuse(resting, "'rest_coefficient' is beyond the strength: " + text(scene, resting));
  // A column "fe" begins with the stress at rest as it is; the domain's gravity stage lets soil yield.
  const double above_bottom = 0.5 * scene.fe.element_size;
  for (const RestingSoil& resting :
       resting_soils(scene, free_fields_at_rest(scene, SourceModel::fe), above_bottom))
    if (!resting.is_given)
      refuse(resting,
             fmt::format("the strength cannot hold the soil's own weight, with which a column \"fe\" "
                         "begins: {}; give it a 'rest_coefficient' in that range, or more strength",
                         text(scene, resting)));
}

} // namespace tremolo::scene
