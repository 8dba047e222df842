#include "wavefield/process/field_from_case.hpp"

#include "motion/band_limited.hpp"
#include "scene/plan/layers.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::wavefield {

namespace {

/// Curves of a layer for the iteration: those of its soil, or a linear layer's constants.
StrainCurves curves_of(const scene::Case& scene, const scene::Layer& layer) {
  const double damping = layer.damping;
  if (!layer.soil || !scene.soils[*layer.soil].curves)
    return {[](double) { return 1.0; }, [damping](double) { return damping; }};
  const scene::StrainCurves& curves = *scene.soils[*layer.soil].curves;
  if (curves.whole)
    return {curves.modulus_reduction, curves.damping};
  return {curves.modulus_reduction,
          [damping, masing = curves.damping](double strain) { return damping + masing(strain); }};
}

/// Layers of soil with curves, cut: the strain at mid-depth stands for a layer.
std::vector<scene::Layer> cut(const scene::Case& scene, const std::vector<scene::Layer>& layers) {
  std::vector<scene::Layer> thin;
  for (scene::Layer layer : layers) {
    const bool varies = layer.soil && scene.soils[*layer.soil].curves;
    const auto parts =
        varies ? static_cast<std::size_t>(std::ceil(layer.thickness / scene.eql.sublayer - 1e-9)) : 1;
    layer.thickness /= static_cast<double>(parts);
    thin.insert(thin.end(), parts, layer);
  }
  return thin;
}

/// Incident acceleration, sampled finely enough for all its frequencies.
std::vector<double> acceleration_of(const Signal& signal, double dt) {
  const auto count = static_cast<std::size_t>(std::ceil((signal.end - signal.begin) / dt)) + 1;
  std::vector<double> velocity;
  for (std::size_t i = 0; i < count; ++i)
    velocity.push_back(signal.velocity(std::min(signal.begin + static_cast<double>(i) * dt, signal.end)));
  return motion::band_limited_slope(velocity, dt);
}

/// The ground of an iteration.
struct CurvedGround {
  LayeredHalfSpace ground;
  std::vector<StrainCurves> curves;
};

CurvedGround curved_ground(const scene::Case& scene, const std::vector<scene::Layer>& layers) {
  CurvedGround result{ground_from_case(scene, layers), {}};
  // The damping of a strain curve knows no frequency.
  if (result.ground.damping.model == DampingModel::none)
    result.ground.damping.model = DampingModel::hysteretic;
  result.curves.reserve(layers.size());
  for (const scene::Layer& layer : layers)
    result.curves.push_back(curves_of(scene, layer));
  return result;
}

/// @param solve  of ground, curves, wave, angle, what is given, and options: the iteration
template <class Solve, class Given>
EquivalentLinearResult iterated(const scene::Case& scene, const std::vector<scene::Layer>& layers,
                                const Solve& solve, const Given& given) {
  const auto [ground, curves] = curved_ground(scene, layers);
  const Incidence incidence = incidence_of(scene.motion);
  const EquivalentLinearOptions options{.strain_ratio = scene.eql.strain_ratio,
                                        .tolerance = scene.eql.tolerance,
                                        .max_iterations = scene.eql.iterations,
                                        .allow_non_convergence = scene.eql.allow_unconverged};
  try {
    return solve(ground, curves, incidence.wave, incidence.angle_rad, given, options);
  } catch (const NotConverged& error) {
    throw std::runtime_error(
        fmt::format("{}: {}; `[eql] unconverged = \"allow\"` takes the last step as it is",
                    scene.file.string(), error.what()));
  }
}

} // namespace

EquivalentLinearResult equivalent_linear_from_case(const scene::Case& scene,
                                                   const scene::SourceProcess& source) {
  const auto layers = cut(scene, scene::layers(scene, source));
  const LayeredHalfSpace ground = ground_from_case(scene, layers);
  // Without layers there is nothing whose stiffness could follow the strain: one pass, no change.
  if (layers.empty())
    return {.profile = ground, .iterations = {EquivalentLinearIteration{}}, .converged = true};
  const Signal signal = incident_signal(scene.motion, ground);
  const double dt = 0.5 / signal.highest_frequency;
  const auto acceleration = acceleration_of(signal, dt);
  return iterated(scene, layers, equivalent_linear, IncidentAcceleration{acceleration, dt});
}

EquivalentLinearResult equivalent_linear_from_case(const scene::Case& scene,
                                                   const scene::SourceProcess& source,
                                                   const RecordedMotion& record) {
  return iterated(scene, cut(scene, scene::layers(scene, source)), equivalent_linear_under_record, record);
}

std::vector<std::size_t> layers_beyond_their_curves(const scene::Case& scene,
                                                    const scene::SourceProcess& source,
                                                    std::span<const double> largest_strains) {
  const auto layers = cut(scene, scene::layers(scene, source));
  std::vector<std::size_t> beyond;
  for (std::size_t j = 0; j < layers.size(); ++j) {
    if (!layers[j].soil || !scene.soils[*layers[j].soil].curves)
      continue;
    // Behind its last row a table keeps the value of that, up to a strain of 1 and further.
    const scene::StrainCurves& curves = *scene.soils[*layers[j].soil].curves;
    const double effective = scene.eql.strain_ratio * largest_strains[j];
    if (curves.whole && curves.modulus_reduction(effective) == curves.modulus_reduction(1.0))
      beyond.push_back(j);
  }
  return beyond;
}

Superposition field_from_case(const scene::Case& scene, const scene::SourceProcess& source) {
  if (source.field.model == scene::SourceModel::eql)
    return field_from_case(scene, source, equivalent_linear_from_case(scene, source));
  return elastic_field(scene, scene::layers(scene, source), source.surface);
}

Superposition field_from_case(const scene::Case& scene, const scene::SourceProcess& source,
                              const EquivalentLinearResult& result) {
  return field_in(result.profile, ground_from_case(scene, scene::layers(scene, source)), scene,
                  source.surface);
}

std::string summary(const EquivalentLinearResult& result) {
  const auto& last = result.iterations.back();
  const double strain = last.largest_strain.empty() ? 0.0 : std::ranges::max(last.largest_strain);
  std::string text =
      fmt::format("{} after {} iterations, last changes {:.2g} % of modulus and {:.2g} % of damping, largest "
                  "strain {:.3g}",
                  result.converged ? "converged" : "NOT converged", result.iterations.size(),
                  100.0 * last.modulus_change, 100.0 * last.damping_change, strain);
  if (!result.held_damping.empty())
    text += fmt::format(", damping held at {} where the curves ask for more in {} of {} layers, first {}",
                        largest_damping, result.held_damping.size(), result.profile.layers.size(),
                        depth_range(result.profile, result.held_damping.front()));
  return text;
}

std::vector<Point> points_on_line(double x, std::span<const double> levels) {
  std::vector<Point> points;
  points.reserve(levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const bool below = i + 1 < levels.size() && levels[i] == levels[i + 1];
    points.push_back({x, levels[i], below ? Side::below : Side::above});
  }
  return points;
}

} // namespace tremolo::wavefield
