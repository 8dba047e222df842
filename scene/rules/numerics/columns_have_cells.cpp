#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void columns_have_cells(const Case& scene, Findings& findings) {
  using enum SourceModel;
  const auto need = [&](double size, const char* table, const char* key) {
    if (!(size > 0.0) && findings.sound("mesh"))
      findings.add(
          fmt::format("{}.{}", table, key),
          fmt::format("missing '{}' in [{}]: half of [mesh] size, which this file has not", key, table));
  };
  switch (scene.boundary.left.field.model) {
  case fe:
    return need(scene.fe.element_size, "fe", "element_size");
  case ode:
    return need(scene.ode.cell_size, "ode", "cell_size");
  case mpm:
    if (!(scene.mesh.size > 0.0) && findings.sound("mesh"))
      findings.add("mesh", "missing [mesh]: model = \"mpm\" is a column of its cells, from its 'box' up");
    return;
  default:
    return;
  }
}

} // namespace tremolo::scene
