#pragma once

#include <string>

namespace tremolo {

/// Folder of the sources, which holds cases/ and docs/.
std::string source_dir();

/// Folder of the programs of this build.
std::string program_dir();

} // namespace tremolo
