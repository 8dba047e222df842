#include "freefield/process/incident_wave.hpp"

namespace tremolo::freefield {

IncidentWave::IncidentWave(const scene::Case& scene)
    : motion_(scene::motion(scene.motion)), wave_(scene.motion.wave), half_space_(scene.halfspace),
      speed_(wave_ == scene::Wave::sv ? half_space_.s_wave_speed() : half_space_.p_wave_speed()),
      y_reference_(scene.motion.reference.y) {}

Velocity IncidentWave::velocity(double y, double time) const {
  const double v = motion_.velocity(time - delay(y));
  return wave_ == scene::Wave::sv ? Velocity{v, 0.0} : Velocity{0.0, v};
}

ColumnSample IncidentWave::sample(double y, double time) const {
  // Five-point difference of the smooth motion, a hundredth of its shortest period a step.
  const double h = 0.01 / motion_.highest_frequency();
  const double t = time - delay(y);
  const double v = motion_.velocity(t);
  const double rate = (8.0 * (motion_.velocity(t + h) - motion_.velocity(t - h)) -
                       (motion_.velocity(t + 2.0 * h) - motion_.velocity(t - 2.0 * h))) /
                      (12.0 * h);
  const double impedance = half_space_.density * speed_;
  ColumnSample sample;
  if (wave_ == scene::Wave::sv) {
    sample.vx = v;
    sample.vx_rate = rate;
    sample.sxy = -impedance * v;
    sample.sxy_rate = -impedance * rate;
  } else {
    const double ratio = half_space_.lame() / half_space_.p_modulus();
    sample.vy = v;
    sample.vy_rate = rate;
    sample.syy = -impedance * v;
    sample.syy_rate = -impedance * rate;
    sample.sxx = ratio * sample.syy;
    sample.sxx_rate = ratio * sample.syy_rate;
  }
  return sample;
}

} // namespace tremolo::freefield
