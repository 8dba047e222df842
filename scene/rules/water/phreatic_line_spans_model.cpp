#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void phreatic_line_spans_model(const Case& scene, Findings& findings) {
  if (!scene.water || scene.water->line.empty() || !findings.sound("water") || !findings.sound("mesh.box"))
    return;
  const Polygon& line = scene.water->line;
  const Box& box = scene.mesh.box;
  const auto refuse = [&](const std::string& why) { findings.add("water.line", why); };
  for (std::size_t i = 1; i < line.size(); ++i)
    if (!(line[i].x > line[i - 1].x))
      return refuse(
          fmt::format("corner {} of 'line', x = {:g} m, does not lie to the right of corner {}, x = "
                      "{:g} m: give them from left to right, one level at each x",
                      i + 1, line[i].x, i, line[i - 1].x));
  if (line.front().x > box.x_min || line.back().x < box.x_max)
    refuse(fmt::format(
        "'line' goes from x = {:g} to {:g} m, and the model from x = {:g} to {:g} m: let it reach "
        "over the whole width",
        line.front().x, line.back().x, box.x_min, box.x_max));
  for (const Point& corner : line)
    if (corner.y < box.y_min)
      return refuse(
          fmt::format("'line' goes down to y = {:g} m at x = {:g} m, below the base of the model at y "
                      "= {:g} m: keep it above, or the model deeper",
                      corner.y, corner.x, box.y_min));
}

} // namespace tremolo::scene
