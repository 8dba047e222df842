#pragma once

// The part of its case that a recorded exchange stores, and its comparison with the free field of another
// case.

#include "results/exchange_file.hpp"
#include "scene/plan/plan.hpp"

#include <string>
#include <vector>

namespace tremolo::coupler {

/// All values in force, and a checksum of the motion's record.
std::vector<results::RecordedValue> recorded_values(const scene::Case& scene);

/// Differences between a recording and a case that change the free field of a side, one sentence each:
/// "motion.angle_deg is 15 in the recording, 20 in the case".
///
/// It depends on the motion, the ground (surface, half-space, profile, soils of the profile, damping), the
/// mesh and the box, from which its levels follow, and the numerics of the model that computed it; not on
/// what the domain does with it.
/// @param recorded of which side in the recording
/// @param served at which side of the case
std::vector<std::string> free_field_differences(const std::vector<results::RecordedValue>& recording,
                                                scene::Side recorded, const scene::Case& scene,
                                                scene::Side served);

/// All inputs of a case's free fields as one text: cases with equal texts have the same free fields, and a
/// recording of one serves the others. Empty where a side's free field comes from a recording or from a
/// program of the user, of which nothing is known.
std::string free_field_identity(const scene::Case& scene);

} // namespace tremolo::coupler
