#pragma once

#include "materials/soiltest/apparatus.hpp"

namespace tremolo::soiltest {

/// The stress that a law starts from: without the static bias if drained shearing applies that.
materials::PointStress stress_at_start(const SoilTest& test);

/// The specimen in its initial state, with strains counted from there.
/// @throws std::invalid_argument for a static bias that drained shearing does not reach
materials::PointTest specimen(const materials::Law& law, const SoilTest& test);

/// Brings the specimen from `before` by the part of an increment that ends at a shear stress: false position
/// with the modification of Illinois.
/// @param target, tolerance  tau, Pa
void stop_at_stress(materials::PointTest& point, const Apparatus& apparatus,
                    const materials::PointState& before, double increment, double target, double tolerance);

} // namespace tremolo::soiltest
