#include "scene/plan/resolved.hpp"

#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/service.hpp"
#include "scene/plan/wave/slowness.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace tremolo::scene {

namespace {

/// Plane waves that a source serves by themselves, by index. A column marches all of them together.
std::vector<std::size_t> served_waves(const Case& scene, const SourceProcess& source) {
  return scene.vertical && in_frequency_domain(source.field.model) ? std::vector<std::size_t>{0, 1}
                                                                   : std::vector<std::size_t>{0};
}

} // namespace

std::string resolved_json(const Case& scene, const Plan& plan) {
  using nlohmann::ordered_json;
  ordered_json json;
  json["file"] = scene.file.string();
  json["title"] = scene.title;
  for (const auto& [key, value, origin] : scene.values)
    json["values"].push_back({{"key", key}, {"value", value}, {"origin", origin}});
  json["plan"] = ordered_json::parse(to_json(scene, plan));
  json["served"] = ordered_json::array();
  for (const SourceProcess& source : plan.sources)
    for (const std::size_t wave : served_waves(scene, source)) {
      const double slowness = slowness_x(scene, *scene.plane_waves()[wave]);
      const Service service = scene::service(scene, source, slowness);
      ordered_json fields;
      for (const ServedLine& line : service.lines)
        fields.push_back({{"field", std::string(name(line.field)).append(suffix_of_wave(wave))},
                          {"levels_m", line.levels}});
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
