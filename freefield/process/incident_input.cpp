#include "freefield/process/incident_input.hpp"

#include "scene/plan/layers.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <cmath>

namespace tremolo::freefield {

ColumnInput incident_input(const scene::Case& scene, const scene::SourceProcess& source, double x, double y) {
  const auto ground = wavefield::ground_from_case(scene, scene::layers(scene, source));
  const auto incidence = wavefield::incidence_from_case(scene);
  const auto signal = wavefield::incident_signal(scene, ground);
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

} // namespace tremolo::freefield
