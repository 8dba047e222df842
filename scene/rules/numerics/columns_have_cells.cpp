#include "scene/plan/free_field_traits.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <string_view>

namespace tremolo::scene {

void columns_have_cells(const Case& scene, Findings& findings) {
  const SourceModel model = scene.boundary.left.field.model;
  const FreeFieldTraits& column = traits(model);
  if (!column.marched_in_time || column.element_size(scene) > 0.0 || !findings.sound("mesh"))
    return;
  if (column.of_domain_cells)
    return findings.add(
        "mesh", fmt::format("missing [mesh]: model = \"{}\" is a column of its cells, from its 'box' up",
                            name(model)));
  const std::size_t dot = column.elements.find('.');
  findings.add(std::string(column.elements),
               fmt::format("missing '{}' in [{}]: half of [mesh] size, which this file has not",
                           column.elements.substr(dot + 1), column.elements.substr(0, dot)));
}

} // namespace tremolo::scene
