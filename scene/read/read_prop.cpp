#include "scene/read/read.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

Prop::End read_end(const TableReader& prop, const char* key, const std::vector<Structure>& structures,
                   Findings& findings) {
  const auto table = prop.table(key);
  if (!table) {
    if (findings.sound(prop.path()) && !prop.given(key))
      findings.add(prop.path(key),
                   fmt::format("missing '{} = {{ structure = \"NAME\", at = [x, y] }}' of the prop", key));
    return {};
  }
  const auto structure = structure_index(*table, structures, findings);
  return {structure ? structures[*structure].name : std::string(), table->point("at")};
}

Prop read_prop(const TableReader& table, const std::vector<Structure>& structures, Findings& findings) {
  return {.name = table.text("name"),
          .from = read_end(table, "from", structures, findings),
          .to = read_end(table, "to", structures, findings),
          .stiffness = table.number("stiffness"),
          .prestress = table.optional_number("prestress"),
          .yield = table.optional_number("yield"),
          .bears = table.choice<mpm_domain::Bears>("bears"),
          .path = table.path()};
}

} // namespace

void read_props(Document& document, Findings& findings, Case& scene) {
  for (const auto& table : document.array("prop"))
    scene.props.push_back(read_prop(table, scene.structures, findings));
}

} // namespace tremolo::scene
