#include "scene/plan/service.hpp"
#include "scene/plan/layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tremolo::scene {

namespace {

/// A level per particle from the base to the surface: finer than anything the domain resolves.
std::vector<double> even_levels(const Mesh& mesh, double surface) {
  const double depth = surface - mesh.box.y_min;
  const double spacing = mesh.particle_size();
  const auto intervals = static_cast<int>(std::max(1.0, std::ceil(depth / spacing - 1e-9)));
  std::vector<double> y;
  y.reserve(static_cast<std::size_t>(intervals) + 1);
  for (int i = 0; i < intervals; ++i)
    y.push_back(mesh.box.y_min + depth * i / intervals);
  y.push_back(surface);
  return y;
}

std::vector<double> levels(const Case& scene, const SourceProcess& source) {
  return with_interfaces(even_levels(scene.mesh, source.surface), source.surface, layers(scene, source),
                         1e-3 * scene.mesh.size);
}

} // namespace

Service service(const Case& scene, const SourceProcess& source, double slowness_x) {
  const auto serves = [&](BaseForm field) {
    return std::any_of(source.serves.begin(), source.serves.end(),
                       [&](const Served& s) { return s.field == field; });
  };
  const Box& box = scene.mesh.box;
  Service service;
  if (scene.boundary.base_is_rigid())
    service.lines.push_back({BaseForm::total, {box.y_min}});
  else if (serves(BaseForm::total))
    service.lines.push_back({BaseForm::total, levels(scene, source)});
  if (serves(BaseForm::incident))
    service.lines.push_back({BaseForm::incident, {box.y_min}});
  service.x_line = box.x_min;
  service.start_time = -slowness_x * (box.x_max - box.x_min);
  service.end_time = scene.end();
  return service;
}

const SourceProcess& source_named(const Plan& plan, std::string_view name) {
  const auto source = std::find_if(plan.sources.begin(), plan.sources.end(),
                                   [&](const SourceProcess& s) { return s.name == name; });
  if (source == plan.sources.end()) {
    std::string known;
    for (const SourceProcess& other : plan.sources)
      known += fmt::format("{}'{}'", known.empty() ? "" : ", ", other.name);
    throw std::invalid_argument(fmt::format("the case has no free field named '{}'; it has {}", name, known));
  }
  return *source;
}

} // namespace tremolo::scene
