// A soil whose key varies over depth, v(y), becomes slices between the lines y_k = y_0 + k h of the mesh's
// lattice, each with the constant v((y_k + y_k+1)/2). A smooth v is met to second order in h: the travel time
// int dy/v of a wave, and the force int v dy of a strength, by the midpoint rule.

#include "scene/read/soil/slice_soils.hpp"
#include "mesh/cell_size.hpp"

#include "scene/read/soil/read_soil.hpp"
#include "scene/read/soil/read_water.hpp"
#include "scene/soils/level_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace tremolo::scene {

namespace {

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool empty() const { return !(low < high); }
  void add(double y) {
    low = std::min(low, y);
    high = std::max(high, y);
  }
};

/// Position of the layers of one soil.
void add_layers(Extent& extent, std::size_t soil, const std::vector<Layer>& layers, double surface) {
  double top = surface;
  for (const Layer& layer : layers) {
    if (layer.soil == soil) {
      extent.add(top);
      extent.add(top - layer.thickness);
    }
    top -= layer.thickness;
  }
}

/// Position of a soil in the domain and in the free fields.
Extent extent_of(std::size_t soil, const Case& scene) {
  Extent extent;
  for (const Region& region : scene.regions)
    if (region.soil == soil)
      for (const Point corner : region.polygon)
        extent.add(corner.y);
  add_layers(extent, soil, scene.profile, scene.surface_level);
  for (const LateralBoundary* side : {&scene.boundary.left, &scene.boundary.right})
    add_layers(extent, soil, side->own_profile.empty() ? scene.profile : side->own_profile, side->surface);
  return extent;
}

bool lies_in(std::size_t soil, const std::vector<Layer>& layers) {
  return std::ranges::find(layers, soil, &Layer::soil) != layers.end();
}

/// The ends of slices of one factor, from the top down.
std::vector<double> levels_of(const Extent& extent, const RandomProfile& random) {
  std::vector<double> levels = random.interfaces(extent.high, extent.low);
  levels.insert(levels.begin(), extent.high);
  levels.push_back(extent.low);
  return levels;
}

/// The ends of slices along the lines of the mesh, from the top down.
std::vector<double> levels_of(const Extent& extent, const Mesh& mesh) {
  const double near = mesh::alignment_tolerance(mesh.size);
  std::vector<double> levels = {extent.high};
  double line = std::floor((extent.high - near - mesh.box.y_min) / mesh.size);
  for (; mesh.box.y_min + line * mesh.size > extent.low + near; --line)
    levels.push_back(mesh.box.y_min + line * mesh.size);
  levels.push_back(extent.low);
  return levels;
}

/// The lines between the slices.
std::vector<double> cuts_of(const SoilProfile& profile) {
  return {profile.levels.begin() + 1, profile.levels.end() - 1};
}

/// Whether the table of a profile has values for all of its soil; reports it otherwise.
bool covers(const DepthProfile& profile, const std::string& path, const std::string& soil,
            const Extent& extent, const Case& scene, Findings& findings) {
  const auto* table = std::get_if<LevelTable>(&profile);
  if (table == nullptr)
    return true;
  const double near = mesh::alignment_tolerance(scene.mesh.size);
  const double surface = scene.surface_level;
  const double first = table->by_depth ? surface - extent.high : extent.low;
  const double last = table->by_depth ? surface - extent.low : extent.high;
  if (table->levels.front() <= first + near && table->levels.back() >= last - near)
    return true;
  const std::string_view what = table->by_depth ? "depth" : "elevation";
  findings.add(path,
               fmt::format("the profile is given from {0} {1:g} to {2:g} m, but soil '{3}' lies from {0} "
                           "{4:g} to {5:g} m{6}: give values for all of it",
                           what, table->levels.front(), table->levels.back(), soil, first, last,
                           table->by_depth ? fmt::format(" below [surface] level = {:g} m", surface) : ""));
  return false;
}

/// Keys that go with Vs at one Poisson's ratio, and as which power of it.
constexpr std::array<std::pair<std::string_view, int>, 3> speed_keys = {{{"vs", 1}, {"vp", 1}, {"young", 2}}};

/// Gives the elastic constants of a soil another Vs and the same Poisson's ratio.
void vary_speed(TableReader& soil, double factor) {
  for (const auto& [name, power] : speed_keys)
    if (const auto median = soil.optional_number(name))
      soil.settle(name, *median * std::pow(factor, power), "random_profile");
}

/// Adds the keys that [random_profile] varies, and says so of those that vary anyway.
void add_varied_keys(const TableReader& soil, std::vector<VaryingKey>& keys) {
  for (const auto& [name, power] : speed_keys) {
    const auto median = soil.optional_number(name);
    auto varying = std::ranges::find(keys, name, &VaryingKey::key);
    if (!median)
      continue;
    if (varying == keys.end()) {
      const Key& known = *table_spec(case_keys(), "soil").find(name);
      keys.push_back({std::string(name), std::string(known.unit), fmt::format("{:g}", *median), {}});
      varying = std::prev(keys.end());
    }
    varying->profile += " times the factors of [random_profile]";
  }
}

/// Cuts one soil.
class Slicer {
public:
  Slicer(const toml::table& root, const Case& scene, Findings& findings)
      : root_(root), scene_(scene), findings_(findings) {}

  /// The slices and their values; nothing, and said, where there cannot be any.
  /// @param profiles  over depth; without any the soil is cut where the factor of [random_profile] changes
  /// @param random    whether it has these factors
  std::optional<SoilProfile> cut(const std::string& name, const Extent& extent,
                                 const std::map<std::string, DepthProfile>& profiles, bool random,
                                 std::vector<Soil>& slices) {
    SoilProfile profile;
    if (profiles.empty())
      profile.levels = levels_of(extent, *scene_.random_profile);
    else if (!cut_over_depth(name, extent, profiles, profile))
      return std::nullopt;
    for (std::size_t i = 0; i < profile.slices(); ++i)
      if (!read_slice(name, i, random, profile, slices))
        return std::nullopt;
    return profile;
  }

private:
  bool cut_over_depth(const std::string& name, const Extent& extent,
                      const std::map<std::string, DepthProfile>& profiles, SoilProfile& profile) {
    const std::string path = "soil." + name;
    const double count = (extent.high - extent.low) / scene_.mesh.size;
    if (!(count <= most_slices)) {
      findings_.add(path,
                    fmt::format("soil '{}' varies over depth and would be cut into {:.0f} slices as high "
                                "as the cells, {:g} m, allowed: at most {:.0f}; take larger cells, and "
                                "[[refine]] where they must be small",
                                name, std::ceil(count), scene_.mesh.size, most_slices));
      return false;
    }
    profile.levels = levels_of(extent, scene_.mesh);
    for (const auto& [key, values] : profiles) {
      if (!covers(values, fmt::format("{}.{}", path, key), name, extent, scene_, findings_))
        return false;
      const Key& known = *table_spec(case_keys(), "soil").find(key);
      profile.keys.push_back({key, std::string(known.unit), text(values), {}});
    }
    return true;
  }

  bool read_slice(const std::string& name, std::size_t index, bool random, SoilProfile& profile,
                  std::vector<Soil>& slices) {
    const double top = profile.levels[index];
    const double bottom = profile.levels[index + 1];
    const double y = 0.5 * (top + bottom);
    const SlicePlace place{y, scene_.surface_level - y, level_ground_stress(scene_, y)};
    const std::string path = "soil." + name;
    Findings own(findings_.file());
    own.locate(path, findings_.place(path));
    std::vector<ValueInForce> values;
    DepthProfiles again;
    NamedTable table{name, TableReader(table_spec(case_keys(), "soil"), root_["soil"][name].as_table(), path,
                                       path, {case_keys(), own, values, &again, &place})};
    if (random && index == 0)
      add_varied_keys(table.reader, profile.keys);
    if (random)
      vary_speed(table.reader, scene_.random_profile->factor_at(y));
    slices.push_back(read_soil_of_case(table, scene_, own));
    for (VaryingKey& key : profile.keys)
      key.values.push_back(table.reader.number(key.key));
    try {
      own.throw_if_any();
    } catch (const CaseErrors& errors) {
      for (const Finding& error : errors.errors())
        findings_.add(path, {error.line, error.column, error.table},
                      fmt::format("{} (slice of the soil from y = {:g} to {:g} m)", error.text, top, bottom));
      return false;
    }
    return true;
  }

  const toml::table& root_;
  const Case& scene_;
  Findings& findings_;
};

/// The slices that each soil was divided into.
struct Sliced {
  std::vector<Soil> soils;
  std::vector<std::size_t> first;                ///< of each former soil: index into `soils`
  std::map<std::size_t, SoilProfile> profiles{}; ///< of the former soils that are cut
};

/// Adds the parts of a layer without a soil that differ in their factor.
void add_varied(const Layer& layer, double top, const RandomProfile& random, std::vector<Layer>& cut) {
  std::vector<double> ends = random.interfaces(top, top - layer.thickness);
  ends.push_back(top - layer.thickness);
  for (const double bottom : ends) {
    Layer& part = cut.emplace_back(layer);
    part.thickness = top - bottom;
    part.elastic.young *= std::pow(random.factor_at(0.5 * (top + bottom)), 2); // G goes as Vs squared
    top = bottom;
  }
}

std::vector<Layer> sliced(const std::vector<Layer>& layers, double surface, const Sliced& by,
                          const std::optional<RandomProfile>& random) {
  std::vector<Layer> cut;
  double top = surface;
  for (Layer layer : layers) {
    const double bottom = top - layer.thickness;
    const auto profile = layer.soil ? by.profiles.find(*layer.soil) : by.profiles.end();
    if (layer.soil)
      layer.soil = by.first[*layer.soil];
    if (!layer.soil && random) {
      add_varied(layer, top, *random, cut);
    } else if (profile == by.profiles.end()) {
      cut.push_back(layer);
    } else {
      for (std::size_t i = 0; i < profile->second.slices(); ++i) {
        const double high = std::min(top, profile->second.levels[i]);
        const double low = std::max(bottom, profile->second.levels[i + 1]);
        const double near = 1e-9 * (top - bottom);
        if (!(high - low > near))
          continue;
        Layer& slice = cut.emplace_back(layer);
        slice.thickness = high - low;
        slice.soil = profile->second.first + i;
        slice.elastic = materials::elasticity(by.soils[*slice.soil].law);
      }
    }
    top = bottom;
  }
  return cut;
}

bool any_sliced(const std::vector<Layer>& layers, const Sliced& by, bool random) {
  return std::ranges::any_of(
      layers, [&](const Layer& layer) { return layer.soil ? by.profiles.contains(*layer.soil) : random; });
}

/// Layers under another surface than that of [[profile]] are cut elsewhere.
void slice_layers(Case& scene, const Sliced& by) {
  for (LateralBoundary* side : {&scene.boundary.left, &scene.boundary.right}) {
    if (side->own_profile.empty() && side->surface != scene.surface_level &&
        any_sliced(scene.profile, by, scene.random_profile.has_value()))
      side->own_profile = scene.profile;
    side->own_profile = sliced(side->own_profile, side->surface, by, scene.random_profile);
  }
  scene.profile = sliced(scene.profile, scene.surface_level, by, scene.random_profile);
}

/// All slices of a soil meet a surface as the soil does.
std::vector<SoilContact> against_slices(const std::vector<SoilContact>& soils, const Sliced& by) {
  std::vector<SoilContact> against;
  for (std::size_t s = 0; s < soils.size(); ++s)
    against.insert(against.end(), by.profiles.contains(s) ? by.profiles.at(s).slices() : 1, soils[s]);
  return against;
}

void put_in_place(Case& scene, Sliced by) {
  slice_layers(scene, by);
  for (Region& region : scene.regions) {
    if (const auto profile = by.profiles.find(region.soil); profile != by.profiles.end())
      region.cuts = cuts_of(profile->second);
    region.soil = by.first[region.soil];
  }
  for (Structure& structure : scene.structures)
    structure.against = against_slices(structure.against, by);
  for (Lining& lining : scene.linings)
    lining.against = against_slices(lining.against, by);
  scene.soils = std::move(by.soils);
  for (auto& [soil, profile] : by.profiles)
    scene.soil_profiles.push_back(std::move(profile));
  scene.profile = watered_profile(scene);
  for (LateralBoundary* side : {&scene.boundary.left, &scene.boundary.right})
    side->own_profile = watered(side->own_profile, *side, scene);
}

/// The keys of a soil that vary.
std::map<std::string, DepthProfile> profiles_of(const std::string& soil, const DepthProfiles& profiles) {
  std::map<std::string, DepthProfile> own;
  for (const Key& key : table_spec(case_keys(), "soil").keys)
    if (const auto found = profiles.find(fmt::format("soil.{}.{}", soil, key.name)); found != profiles.end())
      own.emplace(key.name, found->second);
  return own;
}

} // namespace

void slice_soils(const toml::table& root, const DepthProfiles& profiles, Findings& findings, Case& scene) {
  if ((profiles.empty() && !scene.random_profile) || findings.failed())
    return;
  if (!profiles.empty() && !(scene.mesh.size > 0.0)) {
    findings.add(profiles.begin()->first, "a soil that varies over depth is cut into slices as high as the "
                                          "cells of the mesh: [mesh] size and box are needed");
    return;
  }
  Sliced by;
  Slicer slicer(root, scene, findings);
  for (std::size_t s = 0; s < scene.soils.size(); ++s) {
    by.first.push_back(by.soils.size());
    const auto varying = profiles_of(scene.soils[s].name, profiles);
    const bool random = scene.random_profile && lies_in(s, scene.profile);
    const Extent extent = extent_of(s, scene);
    if ((varying.empty() && !random) || extent.empty()) {
      by.soils.push_back(scene.soils[s]);
    } else if (auto profile = slicer.cut(scene.soils[s].name, extent, varying, random, by.soils)) {
      profile->first = by.first.back();
      by.profiles.emplace(s, std::move(*profile));
    }
  }
  if (!findings.failed())
    put_in_place(scene, std::move(by));
}

} // namespace tremolo::scene
