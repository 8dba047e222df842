#include "app/free_field/column/site_tables.hpp"

#include "scene/plan/layers.hpp"
#include "wavefield/layers/site.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <limits>
#include <string>

namespace tremolo::app {

namespace {

/// A layer as a row of a table.
struct Row {
  double top, bottom; ///< m below the surface
  std::string soil;
  double density, vs, vp, damping, contrast;
};

std::vector<Row> rows_of(const scene::Case& scene, const std::vector<scene::Layer>& layers,
                         const wavefield::LayeredHalfSpace& profile) {
  std::vector<Row> rows;
  double top = 0.0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const auto& [thickness, elastic, damping, soil, wet] = layers[i];
    rows.push_back({top, top + thickness, soil ? scene.soils[*soil].name : "linear elastic", elastic.density,
                    elastic.s_wave_speed(), elastic.p_wave_speed(), damping,
                    wavefield::impedance_contrast(profile, i)});
    top += thickness;
  }
  rows.push_back({top, std::numeric_limits<double>::infinity(), "half-space", scene.halfspace.density,
                  scene.halfspace.s_wave_speed(), scene.halfspace.p_wave_speed(), scene.halfspace_damping,
                  std::numeric_limits<double>::quiet_NaN()});
  return rows;
}

results::Table layers_table(const std::vector<Row>& rows) {
  std::vector<std::string> soils;
  for (const Row& row : rows)
    soils.push_back(row.soil);
  results::Table table{{{"soil", "1", std::move(soils)}}};
  const auto add = [&](const char* name, const char* unit, const auto& value) {
    std::vector<double> values;
    for (const Row& row : rows)
      values.push_back(value(row));
    table.columns.push_back({name, unit, std::move(values)});
  };
  add("top", "m", [](const Row& row) { return row.top; });
  add("bottom", "m", [](const Row& row) { return row.bottom; });
  add("density", "kg/m3", [](const Row& row) { return row.density; });
  add("vs", "m/s", [](const Row& row) { return row.vs; });
  add("vp", "m/s", [](const Row& row) { return row.vp; });
  add("damping", "1", [](const Row& row) { return row.damping; });
  add("shear_modulus", "Pa", [](const Row& row) { return row.density * row.vs * row.vs; });
  add("impedance_contrast", "1", [](const Row& row) { return row.contrast; });
  return table;
}

results::Table site_table(const wavefield::LayeredHalfSpace& profile) {
  constexpr double customary_depth = 30.0; // m
  const double depth = profile.thickness();
  const double mean = wavefield::mean_shear_speed(profile, depth);
  const auto one = [](double value) { return std::vector<double>{value}; };
  return {
      {{"vs30", "m/s", one(wavefield::mean_shear_speed(profile, customary_depth))},
       {"depth", "m", one(depth)},
       {"mean_vs", "m/s", one(mean)},
       {"period", "s", one(wavefield::fundamental_period(profile))},
       {"period_of_mean_vs", "s", one(4.0 * depth / mean)},
       {"impedance_contrast", "1", one(wavefield::impedance_contrast(profile, profile.layers.size() - 1))}}};
}

/// Vs at small strain at a depth, m/s.
double small_strain_vs(const std::vector<Row>& rows, double depth) {
  std::size_t i = 0;
  while (i + 1 < rows.size() && depth > rows[i].bottom)
    ++i;
  return rows[i].vs;
}

results::Table strain_compatible(const scene::Case& scene, const wavefield::EquivalentLinearResult& result,
                                 const std::vector<Row>& rows) {
  std::vector<double> tops, bottoms, speeds, ratios, damping, largest, effective;
  double top = 0.0;
  for (std::size_t i = 0; i < result.profile.layers.size(); ++i) {
    const wavefield::Layer& layer = result.profile.layers[i];
    const double initial = small_strain_vs(rows, top + 0.5 * layer.thickness);
    tops.push_back(top);
    bottoms.push_back(top += layer.thickness);
    speeds.push_back(layer.vs);
    ratios.push_back((layer.vs / initial) * (layer.vs / initial));
    damping.push_back(layer.damping);
    largest.push_back(result.iterations.back().largest_strain[i]);
    effective.push_back(scene.eql.strain_ratio * largest.back());
  }
  return {{{"top", "m", std::move(tops)},
           {"bottom", "m", std::move(bottoms)},
           {"vs", "m/s", std::move(speeds)},
           {"modulus_ratio", "1", std::move(ratios)},
           {"damping", "1", std::move(damping)},
           {"largest_strain", "1", std::move(largest)},
           {"effective_strain", "1", std::move(effective)}}};
}

} // namespace

std::vector<results::NamedTable> site_tables(const ColumnGround& ground, const FreeFieldSeries& series) {
  const auto& layers = scene::layers(ground.scene, ground.source);
  const auto profile = wavefield::ground_from_case(ground.scene, layers);
  const auto rows = rows_of(ground.scene, layers, profile);
  std::vector<results::NamedTable> tables{{"/layers", layers_table(rows)}, {"/site", site_table(profile)}};
  if (series.equivalent_linear)
    tables.push_back(
        {"/strain_compatible", strain_compatible(ground.scene, *series.equivalent_linear, rows)});
  return tables;
}

} // namespace tremolo::app
