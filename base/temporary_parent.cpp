#include "base/temporary_parent.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace tremolo {

std::filesystem::path temporary_parent() {
  const char* chosen = std::getenv("TMPDIR");
  if (chosen == nullptr || *chosen == '\0')
    return "/tmp";
  std::error_code trouble;
  if (!std::filesystem::is_directory(chosen, trouble))
    throw std::runtime_error(fmt::format("TMPDIR = {} is no folder", chosen));
  return chosen;
}

} // namespace tremolo
