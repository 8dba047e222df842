#include "app/temporary_folder.hpp"

#include "base/temporary_parent.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>

namespace tremolo::app {

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (temporary_parent() / "tremolo-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr)
    throw std::runtime_error(fmt::format("cannot make a folder like {}: {}", pattern, std::strerror(errno)));
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code nothing_to_be_done;
  std::filesystem::remove_all(path_, nothing_to_be_done);
}

} // namespace tremolo::app
