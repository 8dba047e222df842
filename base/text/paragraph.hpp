#pragma once

#include <string>

namespace tremolo {

/// Breaks a paragraph into lines of at most 120 characters, as pages are written.
std::string wrapped(std::string paragraph);

} // namespace tremolo
