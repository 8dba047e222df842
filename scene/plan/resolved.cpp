#include "scene/plan/resolved.hpp"

#include "scene/plan/service.hpp"
#include "scene/plan/wave/slowness.hpp"

#include <nlohmann/json.hpp>

namespace tremolo::scene {

std::string resolved_json(const Case& scene, const Plan& plan) {
  using nlohmann::ordered_json;
  ordered_json json;
  json["file"] = scene.file.string();
  json["title"] = scene.title;
  for (const auto& [key, value, origin] : scene.values)
    json["values"].push_back({{"key", key}, {"value", value}, {"origin", origin}});
  json["plan"] = ordered_json::parse(to_json(scene, plan));
  const double slowness = slowness_x(scene, scene.motion);
  json["served"] = ordered_json::array();
  for (const SourceProcess& source : plan.sources) {
    const Service service = scene::service(scene, source, slowness);
    ordered_json fields;
    for (const ServedLine& line : service.lines)
      fields.push_back({{"field", name(line.field)}, {"levels_m", line.levels}});
    json["served"].push_back({{"source", source.name},
                              {"x_m", service.x_line},
                              {"slowness_x_s_per_m", slowness},
                              {"from_s", service.start_time},
                              {"to_s", service.end_time},
                              {"fields", fields}});
  }
  return json.dump(2);
}

} // namespace tremolo::scene
