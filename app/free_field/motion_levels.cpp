#include "app/free_field/motion_levels.hpp"

#include "base/samples.hpp"
#include "motion/band_limited.hpp"
#include "motion/record.hpp"
#include "scene/plan/layers.hpp"
#include "wavefield/incident_motion.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace tremolo::app {

namespace {

/// Samples per period of the highest frequency of a motion: two are those of its Nyquist frequency.
constexpr double samples_per_period = 2.0;

std::string level_text(double acceleration) {
  return fmt::format("{:.3g} m/s2 ({:.3g} g)", acceleration, acceleration / motion::standard_gravity);
}

double peak_level(const wavefield::Signal& signal) {
  const double dt = 1.0 / (samples_per_period * signal.highest_frequency);
  const auto count = static_cast<std::size_t>(std::ceil((signal.end - signal.begin) / dt)) + 1;
  std::vector<double> velocity;
  velocity.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double time = signal.begin + static_cast<double>(i) * dt;
    velocity.push_back(time <= signal.end ? signal.velocity(time) : 0.0);
  }
  return peak(motion::band_limited_slope(velocity, dt));
}

/// Takes the component that the wave moves at vertical incidence.
double surface_level(const scene::Case& scene, const wavefield::LayeredHalfSpace& ground,
                     const wavefield::Incidence& incidence, const wavefield::Signal& signal) {
  const auto& side = scene.boundary.left;
  const wavefield::LayeredField field(ground, incidence, side.surface, signal, {.padding = 2.0});
  // The wave comes up, is at the surface, and rings in the layers.
  double travel = std::abs(side.surface - incidence.y_reference) / ground.half_space.vs;
  for (const wavefield::Layer& layer : ground.layers)
    travel += 4.0 * layer.thickness / layer.vs;
  const double dt = 1.0 / (samples_per_period * signal.highest_frequency);
  const auto count = static_cast<std::size_t>(std::ceil((signal.end - signal.begin + 2.0 * travel) / dt)) + 1;
  const std::array place = {wavefield::Point{incidence.x_reference, side.surface}};
  const auto history = field.sample(place, {signal.begin, dt, count}, wavefield::Part::total,
                                    {.displacement = false, .stress = false, .strain = false});
  const bool shear = incidence.wave == wavefield::WaveType::SV;
  return peak(shear ? history.front().vx_rate : history.front().vy_rate);
}

std::string text_of_table(const scene::MotionInput& input) {
  return level_text(peak_level(wavefield::signal_of(scene::motion(input)))) + " of the shaking table\n";
}

std::string text_of_wave(const scene::Case& scene, const scene::MotionInput& input) {
  const auto ground = wavefield::ground_from_case(scene, scene::layers(scene, scene.boundary.left));
  const wavefield::Incidence incidence = wavefield::incidence_of(input);
  std::string text;
  try {
    const wavefield::Signal signal = wavefield::incident_signal(input, ground);
    const double incident = peak_level(signal);
    text += level_text(incident) + " as incident wave";
    if (!wavefield::is_post_critical(ground.half_space, incidence))
      text += fmt::format(", {} at an outcrop",
                          level_text(incident * std::abs(wavefield::outcrop_factor(ground, incidence.wave,
                                                                                   incidence.angle_rad))));
    return text + fmt::format(", {} at the surface of the elastic free field\n",
                              level_text(surface_level(scene, ground, incidence, signal)));
  } catch (const std::exception& reason) {
    return text + fmt::format("{}not known{}: {}\n", text.empty() ? "" : ", ",
                              text.empty() ? "" : " at the surface", reason.what());
  }
}

} // namespace

std::string motion_levels_text(const scene::Case& scene) {
  std::string text;
  for (const scene::MotionInput* input : scene.plane_waves())
    text += fmt::format("{}: peak acceleration {}", input == &scene.motion ? "motion" : "vertical motion",
                        scene.boundary.takes_waves() ? text_of_wave(scene, *input) : text_of_table(*input));
  return text;
}

} // namespace tremolo::app
