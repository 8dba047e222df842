#pragma once

namespace tremolo::mpm_domain {

/// The array of a checkpoint that says how many static stages were over, gravity among them.
inline constexpr const char* stages_over_name = "static.over";

} // namespace tremolo::mpm_domain
