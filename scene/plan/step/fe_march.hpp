#pragma once

#include "scene/case.hpp"

#include <vector>

namespace tremolo::scene {

/// How the column `fe` marches a ground.
enum class FeMarch {
  one_phase,  ///< by the integrator of [fe]
  two_phases, ///< explicitly: there is water, or soil that begins with a memory of its geostatic stress
  at_an_angle ///< explicitly but for what the horizontal slowness of the wave couples
};

FeMarch fe_march(const Case& scene, const std::vector<Layer>& layers);

} // namespace tremolo::scene
