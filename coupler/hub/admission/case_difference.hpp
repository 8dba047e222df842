#pragma once

#include <string>
#include <string_view>

namespace tremolo::coupler {

/// The first line in which two case files differ, as both have it, with the table it stands in: "line 7,
/// [mesh]: 'size = 1.0' against 'size = 0.5'". Empty for equal texts.
std::string case_difference(std::string_view theirs, std::string_view ours);

} // namespace tremolo::coupler
