#include "freefield/process/incident_input.hpp"

#include "scene/plan/layers.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tremolo::freefield {

ColumnInput incident_input(const scene::MotionInput& wave, const wavefield::LayeredHalfSpace& ground,
                           double x, double y) {
  const auto incidence = wavefield::incidence_of(wave);
  const auto signal = wavefield::incident_signal(wave, ground);
  const bool shear = incidence.wave == wavefield::WaveType::SV;
  const double speed = shear ? ground.half_space.vs : ground.half_space.vp;
  const double sine = std::sin(incidence.angle_rad);
  const double cosine = std::cos(incidence.angle_rad);
  const double delay = ((x - incidence.x_reference) * sine + (y - incidence.y_reference) * cosine) / speed;
  return {BaseKind::compliant,
          [signal, delay, shear, sine, cosine](double time) {
            const double v = signal.velocity(time - delay);
            return shear ? Velocity{v * cosine, -v * sine} : Velocity{v * sine, v * cosine};
          },
          signal.begin + delay, signal.highest_frequency};
}

ColumnInput sum(ColumnInput first, const ColumnInput& second) {
  first.velocity = [one = std::move(first.velocity), other = second.velocity](double time) {
    const Velocity a = one(time), b = other(time);
    return Velocity{a.x + b.x, a.y + b.y};
  };
  first.begin = std::min(first.begin, second.begin);
  first.highest_frequency = std::max(first.highest_frequency, second.highest_frequency);
  return first;
}

ColumnInput incident_input(const scene::Case& scene, const scene::SourceProcess& source, double x, double y) {
  const auto ground = wavefield::ground_from_case(scene, scene::layers(scene, source));
  ColumnInput input = incident_input(scene.motion, ground, x, y);
  return scene.vertical ? sum(std::move(input), incident_input(*scene.vertical, ground, x, y)) : input;
}

} // namespace tremolo::freefield
