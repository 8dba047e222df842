#include "scene/read/read.hpp"
#include "scene/text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene {

std::optional<Outline> read_outline(const TableReader& table, std::string_view polygon,
                                    std::string_view circle_key, Findings& findings) {
  const auto round = table.table(circle_key);
  if (round && table.given(polygon)) {
    findings.add(table.path(circle_key),
                 fmt::format("'{}' and '{}' exclude each other: remove one", polygon, circle_key));
    return std::nullopt;
  }
  if (round) {
    const bool sound = findings.sound(round->path("centre")) && findings.sound(round->path("radius"));
    return Outline{circle_key, sound ? circle(round->point("centre"), round->number("radius")) : Polygon{}};
  }
  if (!table.given(polygon))
    return std::nullopt;
  return Outline{polygon, table.polygon(polygon)};
}

std::vector<SoilContact> read_against(const TableReader& table, const std::vector<Soil>& soils,
                                      Findings& findings) {
  const SoilContact own{table.number("friction"), table.number("adhesion")};
  std::vector<SoilContact> against(soils.size(), own);
  std::vector<bool> named(soils.size(), false);
  for (const TableReader& one : table.tables("against")) {
    const auto soil = soil_index(one, soils, findings);
    if (!soil)
      continue;
    if (named[*soil])
      findings.add(one.path("soil"), fmt::format("soil '{}' stands twice in 'against'", soils[*soil].name));
    if (!one.given("friction") && !one.given("adhesion"))
      findings.add(one.path(), fmt::format("neither 'friction' nor 'adhesion' against soil '{}': give one, "
                                           "or remove the table",
                                           soils[*soil].name));
    named[*soil] = true;
    against[*soil] = {one.optional_number("friction").value_or(own.friction),
                      one.optional_number("adhesion").value_or(own.adhesion)};
  }
  return against;
}

namespace {

/// Stiffness of an elastic structure; empty for a rigid one.
std::optional<mpm_domain::Stiffness> read_stiffness(const TableReader& table, Findings& findings) {
  const bool elastic = table.given("young") || table.given("poisson");
  if (table.given("rigid") && findings.sound(table.path("rigid"))) {
    if (elastic)
      findings.add(table.path("rigid"), "'rigid' and 'young' exclude each other: remove one");
    else if (!table.boolean("rigid"))
      findings.add(table.path("rigid"), "'rigid' = false: give 'young' and 'poisson' in its place");
    return std::nullopt;
  }
  if (!elastic) {
    if (findings.sound(table.path()) && findings.sound(table.path("rigid")))
      findings.add(table.path("rigid"), "missing 'rigid' = true, or 'young' and 'poisson' of an elastic "
                                        "structure");
    return std::nullopt;
  }
  if (!complete(table, findings, "young", "poisson"))
    return std::nullopt;
  return mpm_domain::Stiffness{table.number("young"), table.number("poisson")};
}

Structure read_structure(const TableReader& table, const std::vector<Soil>& soils, Findings& findings) {
  const auto outline = read_outline(table, "polygon", "circle", findings);
  if (!table.given("polygon") && !table.given("circle") && findings.sound(table.path()))
    findings.add(table.path("polygon"), "missing 'polygon' or 'circle': the outline of the structure");
  return {.name = table.text("name"),
          .outline = outline.value_or(Outline{}),
          .hole = read_outline(table, "hole", "hole_circle", findings),
          .density = table.number("density"),
          .stiffness = read_stiffness(table, findings),
          .friction = table.number("friction"),
          .against = read_against(table, soils, findings),
          .path = table.path()};
}

} // namespace

std::optional<std::size_t> structure_index(const TableReader& table, const std::vector<Structure>& structures,
                                           Findings& findings) {
  if (!table.given("structure"))
    return std::nullopt;
  const std::string name = table.text("structure");
  const auto found = std::ranges::find(structures, name, &Structure::name);
  if (found != structures.end())
    return static_cast<std::size_t>(found - structures.begin());
  std::vector<std::string_view> known;
  for (const Structure& structure : structures)
    known.push_back(structure.name);
  if (findings.sound(table.path("structure")))
    findings.add(table.path("structure"),
                 fmt::format("structure '{}' is not defined, {}", name, suggestion(name, known)));
  return std::nullopt;
}

void read_structures(Document& document, Findings& findings, Case& scene) {
  for (const auto& table : document.array("structure"))
    scene.structures.push_back(read_structure(table, scene.soils, findings));
}

} // namespace tremolo::scene
