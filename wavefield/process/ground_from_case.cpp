#include "wavefield/process/ground_from_case.hpp"

#include "scene/plan/wave/motion.hpp"
#include "scene/soils/viscous_damping.hpp"
#include "wavefield/incident_motion.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace tremolo::wavefield {

namespace {

DampingModel damping_model(const scene::Damping& damping) {
  switch (damping.model) {
  case scene::DampingModel::kelvin_voigt:
    return DampingModel::kelvin_voigt;
  case scene::DampingModel::hysteretic:
    return DampingModel::hysteretic;
  case scene::DampingModel::shake:
    return DampingModel::shake;
  case scene::DampingModel::kjartansson:
    return DampingModel::kjartansson;
  case scene::DampingModel::constant:
    return DampingModel::constant;
  case scene::DampingModel::rayleigh:
    return DampingModel::rayleigh;
  case scene::DampingModel::none:
    return DampingModel::none;
  }
  throw std::logic_error("a damping model without a name");
}

/// The incident motion of a record that begins like `within`. A record of velocities rises in its first 0.1
/// s, so it is given zeros there.
Signal smooth(const Deconvolution& deconvolution, double dt, const scene::Motion& within) {
  constexpr double zeros = 0.2; // s
  std::vector<double> velocity(static_cast<std::size_t>(std::ceil(zeros / dt)), 0.0);
  const double begin = within.begin() - dt * static_cast<double>(velocity.size() + deconvolution.lead);
  velocity.insert(velocity.end(), deconvolution.incident.begin(), deconvolution.incident.end());
  const auto shape = scene::Motion::of_velocity(velocity, dt);
  return {[shape, begin](double t) { return shape.velocity(t - begin); }, begin, begin + shape.end(),
          within.highest_frequency()};
}

} // namespace

Signal signal_of(const scene::Motion& motion) {
  return {[motion](double t) { return motion.velocity(t); }, motion.begin(), motion.end(),
          motion.highest_frequency()};
}

LayeredHalfSpace ground_from_case(const scene::Case& scene, const std::vector<scene::Layer>& layers) {
  const auto& deep = scene.halfspace;
  LayeredHalfSpace ground;
  ground.half_space = {deep.density, deep.s_wave_speed(), deep.p_wave_speed()};
  ground.half_space_damping = scene.halfspace_damping;
  // At oblique incidence only columns support Rayleigh damping, which is part of their equations. They need
  // only the incident wave from this ground, which no layer has affected.
  const bool by_column = scene.damping.model == scene::DampingModel::rayleigh && scene.is_oblique();
  ground.damping = {by_column ? DampingModel::none : damping_model(scene.damping),
                    scene.damping.reference_hz.value_or(0.0), scene.damping.band, scene.damping.frequencies};
  for (const scene::Layer& layer : layers)
    ground.layers.push_back({.thickness = layer.thickness,
                             .density = layer.elastic.density,
                             .vs = layer.elastic.s_wave_speed(),
                             .vp = layer.elastic.p_wave_speed(),
                             .damping = by_column ? 0.0 : layer.damping,
                             .relaxing_share_p = scene::relaxing_share_p(scene, layer)});
  return ground;
}

Incidence incidence_of(const scene::MotionInput& wave) {
  return {wave.wave == scene::Wave::sv ? WaveType::SV : WaveType::P,
          wave.angle_deg * std::numbers::pi / 180.0, wave.reference.x, wave.reference.y};
}

Signal incident_signal(const scene::MotionInput& wave, const LayeredHalfSpace& ground) {
  const scene::Motion motion = scene::motion(wave);
  const Incidence incidence = incidence_of(wave);
  switch (wave.kind) {
  case motion::MotionKind::incident:
    return signal_of(motion);
  case motion::MotionKind::outcrop: {
    Signal signal = signal_of(motion);
    signal.velocity = [motion, factor = outcrop_factor(ground, incidence.wave, incidence.angle_rad)](
                          double t) { return motion.velocity(t) / factor; };
    return signal;
  }
  case motion::MotionKind::within: {
    const scene::SampledMotion samples = scene::sampled(motion);
    return smooth(
        incident_from_within(ground, incidence.wave, incidence.angle_rad, samples.velocity, samples.dt),
        samples.dt, motion);
  }
  }
  throw std::logic_error("a kind of motion without a name");
}

Superposition field_in(const LayeredHalfSpace& ground, const LayeredHalfSpace& elastic,
                       const scene::Case& scene, double surface_level) {
  std::vector<LayeredField> fields;
  for (const scene::MotionInput* wave : scene.plane_waves())
    fields.emplace_back(ground, incidence_of(*wave), surface_level, incident_signal(*wave, elastic));
  return Superposition(std::move(fields));
}

Superposition elastic_field(const scene::Case& scene, const std::vector<scene::Layer>& layers,
                            double surface_level) {
  const LayeredHalfSpace ground = ground_from_case(scene, layers);
  return field_in(ground, ground, scene, surface_level);
}

} // namespace tremolo::wavefield
