// The only object of the tests that knows where the clone lies, so that a compiler cache serves all others to
// any clone.
#include "tests/support/paths.hpp"

namespace tremolo {

std::string source_dir() {
  return TREMOLO_SOURCE_DIR;
}

std::string program_dir() {
  return TREMOLO_BIN_DIR;
}

} // namespace tremolo
