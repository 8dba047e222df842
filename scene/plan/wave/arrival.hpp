#pragma once

#include "scene/case.hpp"

namespace tremolo::scene {

/// Time that an incident wave takes from its reference point to the model's lower left corner, s.
double delay_to_model(const Case& scene, const MotionInput& wave);

/// When a share (1) of the Arias intensity of a shaking of [motion] has reached the model there, s of the
/// soil's time.
double arrival_of_intensity(const Case& scene, const ShakingMotion& shaking, double share);
/// The share with which strong motion is over.
inline constexpr double strong_motion_over = 0.99;

/// Largest velocity of the incident wave of [motion], m/s; of a motion within the ground, which is not known
/// without the layers, that of an outcrop of the same motion.
double incident_peak_velocity(const Case& scene);

} // namespace tremolo::scene
