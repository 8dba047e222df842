#include "motion/measures.hpp"
#include "motion/read/read.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tremolo::scene {

namespace {

/// The pulse's central frequency, or one over the record's mean period, Hz.
double typical_frequency(const MotionSource& source) {
  if (const auto* pulse = std::get_if<RickerPulse>(&source))
    return pulse->frequency;
  const auto& file = std::get<MotionFile>(source);
  const double period = motion::measures(motion::read_record(file.path, file.as)).mean_period;
  return period > 0.0 ? 1.0 / period : 1.0;
}

/// Damping ratio times the time that a shear wave takes on its way up, s.
struct DampedTimes {
  double field = 0.0;      ///< through the free field
  double domain = 0.0;     ///< through the domain beside it
  double difference = 0.0; ///< sum of the differences, of whatever sign, at all levels
};

/// The material at a level of a side's free field.
Layer layer_at(const Case& scene, const LateralBoundary& side, double y) {
  double bottom = side.surface;
  for (const Layer& layer : layers(scene, side))
    if ((bottom -= layer.thickness) < y)
      return layer;
  return {.elastic = scene.halfspace, .damping = scene.halfspace_damping};
}

/// Along an edge of the box, cell by cell; x lies in the cells at the edge.
DampedTimes damped_times(const Case& scene, const LateralBoundary& side, double x) {
  const Mesh& mesh = scene.mesh;
  DampedTimes times;
  const auto cells = static_cast<int>(std::ceil((side.surface - mesh.box.y_min) / mesh.size - 0.5));
  for (int i = 0; i < cells; ++i) {
    const double y = mesh.box.y_min + (i + 0.5) * mesh.size;
    const auto region = std::ranges::find_if(scene.regions, [&](const Region& one) {
      return contains(one.polygon, {x, y});
    });
    if (region == scene.regions.end())
      continue;
    const Soil& soil = scene.soils[region->soil_at(y)];
    const Layer layer = layer_at(scene, side, y);
    const double field = layer.damping * mesh.size / layer.elastic.s_wave_speed();
    const double domain = soil.damping * mesh.size / materials::elasticity(soil.law).s_wave_speed();
    times.field += field;
    times.domain += domain;
    times.difference += std::abs(field - domain);
  }
  return times;
}

/// The damping of the layers is that of the soil beside them.
void ratios_agree(const Case& scene, Findings& findings) {
  const auto& [sides, left, right, base] = scene.boundary;
  const Mesh& mesh = scene.mesh;
  const DampedTimes times =
      std::max(damped_times(scene, left, mesh.box.x_min + 0.5 * mesh.size),
               damped_times(scene, right, mesh.box.x_max - 0.5 * mesh.size),
               [](const auto& a, const auto& b) { return a.difference < b.difference; });
  constexpr double negligible = 1e-3;
  double frequency = 0.0; // of what is damped most
  for (const ShakingMotion& shaking : scene.motion.shakings)
    frequency = std::max(frequency, typical_frequency(shaking.source));
  const auto loss = [frequency](double time) {
    return 1.0 - std::exp(-2.0 * std::numbers::pi * frequency * time);
  };
  if (loss(times.difference) < negligible)
    return;
  findings.add(
      "damping.model",
      fmt::format(
          "the free field is not damped like the domain beside it: a shear wave of {:.3g} Hz loses "
          "{:.2g} % of its amplitude on its way up through the free field, and {:.2g} % on its way up "
          "through the domain; [soil.NAME] damping is that of the domain and of layers that name the "
          "soil",
          frequency, 100.0 * loss(times.field), 100.0 * loss(times.domain)));
}

/// So is the way in which it depends on frequency.
void frequencies_agree(const Case& scene, Findings& findings) {
  using enum DampingModel;
  const Damping& damping = scene.damping;
  const auto& [sides, left, right, base] = scene.boundary;
  if (damping.model != rayleigh && damping.model != kelvin_voigt && damping.model != constant &&
      damping.reference_hz &&
      std::ranges::any_of(std::array{left.field.model, right.field.model, base.field.model},
                          in_frequency_domain))
    findings.add("damping.model",
                 fmt::format("the damping of the domain is proportional to frequency, that of the free field "
                             "(\"{}\") hardly depends on it: they agree at {} Hz alone; model = "
                             "\"constant\" is the same in both",
                             name(damping.model), *damping.reference_hz));
}

} // namespace

void domain_is_damped_like_free_field(const Case& scene, Findings& findings) {
  if (!scene.boundary.has_lateral_fields() || scene.damping.model == DampingModel::none)
    return;
  ratios_agree(scene, findings);
  if (domain_is_damped(scene))
    frequencies_agree(scene, findings);
}

} // namespace tremolo::scene
