#pragma once

namespace tremolo::mpm_domain {

/// Whether this build knows more than dry elastic soil on a uniform grid by FLIP. A build that defines
/// TREMOLO_DRY_ELASTIC_ONLY has all else compiled out of the passes over particles and nodes: the yardstick
/// of the test that effects which are off cost nothing (tests/system/instructions).
#ifdef TREMOLO_DRY_ELASTIC_ONLY
inline constexpr bool all_effects = false;
#else
inline constexpr bool all_effects = true;
#endif

} // namespace tremolo::mpm_domain
