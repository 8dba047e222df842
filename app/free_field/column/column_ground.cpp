#include "app/free_field/column/column_ground.hpp"

#include "app/free_field/series/computed_field.hpp"
#include "freefield/process/column_from_case.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/service.hpp"
#include "scene/plan/wave/motion.hpp"
#include "scene/plan/wave/slowness.hpp"
#include "wavefield/process/field_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace tremolo::app {

ColumnGround column_ground(const std::filesystem::path& file, scene::SourceModel model) {
  auto scene = scene::load_free_field(file, model);
  const scene::SourceProcess source{.name = "column", .field = {model, {}}, .surface = scene.surface_level};
  deepest_level(scene, source);
  const double x = scene.motion.reference.x;
  return {std::move(scene), source, x};
}

double deepest_level(const scene::Case& scene, const scene::SourceProcess& source) {
  const double base = scene::base_level(source.surface, scene::layers(scene, source));
  if (base < source.surface)
    return base;
  throw std::runtime_error(
      fmt::format("{}: a column needs layers, and this ground is the [halfspace] alone; [[profile]] gives "
                  "some, or [[boundary.left.profile]] those of a side, which are computed with --side left "
                  "or --side right",
                  scene.file.string()));
}

wavefield::TimeGrid column_times(const ColumnGround& ground, std::optional<double> duration,
                                 std::optional<double> every) {
  /// Histories of this many times at all levels take some 3 GB.
  constexpr double most_times = 2e5;
  const auto& [scene, source, x] = ground;
  double start = 0.0;
  double motion_end = 0.0;
  double highest_frequency = 0.0;
  for (const scene::MotionInput* wave : scene.plane_waves()) {
    const auto motion = scene::motion(*wave);
    const double delay = scene::slowness_x(scene, *wave) * (x - wave->reference.x);
    start = std::min(start, motion.begin() + delay);
    motion_end = std::max(motion_end, motion.end() + std::max(0.0, delay));
    highest_frequency = std::max(highest_frequency, motion.highest_frequency());
  }
  // A wave that has gone up and down the column four times has left it for practical purposes.
  double crossing = 0.0;
  for (const scene::Layer& layer : scene::layers(scene, source))
    crossing += layer.thickness / layer.elastic.s_wave_speed();
  const double waves_end = motion_end + 8.0 * crossing;
  const double end = duration.value_or(scene.timed.size() > 1 ? scene.end_of_soil_time() : waves_end);
  if (!(end > start && std::isfinite(end)))
    throw std::runtime_error(fmt::format("--duration: {} s, must be finite and > {:.4g} s", end, start));
  const double fine = std::min(0.005, 0.25 / highest_frequency);
  const double dt =
      every.value_or(scene.timed.size() > 1 ? std::max(fine, (end - start) / (0.5 * most_times)) : fine);
  const double steps = std::floor((end - start) / dt + 1e-9);
  if (!(steps >= 1.0 && steps < most_times))
    throw std::runtime_error(fmt::format(
        "--every: {:.4g} s makes {:.3g} times from {:.4g} to {:.4g} s, allowed are 2 to {:.0e}: --every from "
        "{:.3g} to {:.3g} s, or another --duration",
        dt, steps + 1.0, start, end, most_times, (end - start) / (most_times - 1.0), end - start));
  return {start, dt, static_cast<std::size_t>(steps) + 1};
}

std::string start_column(const ColumnGround& ground) {
  const auto& [scene, source, x] = ground;
  const wavefield::TimeGrid times = column_times(ground);
  const auto field = computed_field(scene, source, x, times.start);
  field->try_surface(source.surface, times.start,
                     times.start + times.dt * static_cast<double>(times.count - 1));
  return field->description();
}

namespace {

void start_waves(const scene::Case& scene, const scene::SourceProcess& source) {
  if (std::ranges::none_of(
          source.serves, [](const scene::Served& served) { return served.field == scene::BaseForm::total; }))
    return;
  const wavefield::Superposition field = wavefield::field_from_case(scene, source);
  for (const wavefield::LayeredField& wave : field.waves()) {
    const scene::Service service = scene::service(scene, source, wave.slowness_x());
    sample_surface(wave, {service.x_line, source.surface}, service.start_time, service.end_time, false);
  }
}

void start_source(const scene::Case& scene, const scene::SourceProcess& source) {
  using enum scene::SourceModel;
  switch (source.field.model) {
  case wave:
    return start_waves(scene, source);
  case fe:
  case ode: {
    const scene::Service service = scene::service(scene, source, scene::slowness_x(scene, scene.motion));
    freefield::column_from_case(scene, source, service.x_line, service.start_time);
    return;
  }
  default:
    return;
  }
}

} // namespace

void start_free_fields(const scene::Case& scene, const scene::Plan& plan) {
  for (const scene::SourceProcess& source : plan.sources)
    try {
      start_source(scene, source);
    } catch (const std::exception& refusal) {
      throw std::runtime_error(fmt::format("{}: [boundary.{}] model = \"{}\": {}", scene.file.string(),
                                           scene::name(source.serves.front().side),
                                           scene::name(source.field.model), refusal.what()));
    }
}

std::string layers_text(const ColumnGround& ground) {
  const auto& [scene, source, x] = ground;
  std::string text = fmt::format("  {:>9} {:>9} {:>9} {:>9} {:>9} {:>8}  {}\n", "top (m)", "bottom", "kg/m3",
                                 "Vs (m/s)", "Vp (m/s)", "damping", "soil");
  double top = source.surface;
  const auto line = [&](double bottom, const materials::Elasticity& e, double damping,
                        std::string_view name) {
    text += fmt::format("  {:>9.4g} {:>9.4g} {:>9.4g} {:>9.4g} {:>9.4g} {:>8.3g}  {}\n", top, bottom,
                        e.density, e.s_wave_speed(), e.p_wave_speed(), damping, name);
    top = bottom;
  };
  for (const scene::Layer& layer : scene::layers(scene, source))
    line(top - layer.thickness, layer.elastic, layer.damping,
         layer.soil ? fmt::format("{}, {}{}", scene.soils[*layer.soil].name,
                                  materials::name(scene.soils[*layer.soil].law), layer.wet ? ", wet" : "")
                    : "linear elastic");
  line(-std::numeric_limits<double>::infinity(), scene.halfspace, scene.halfspace_damping, "half-space");
  return text;
}

} // namespace tremolo::app
