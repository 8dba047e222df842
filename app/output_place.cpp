#include "app/output_place.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <stdexcept>

namespace tremolo::app {

namespace fs = std::filesystem;

void require_writable(const fs::path& out) {
  const auto refuse = [&out](const std::string& why) {
    throw std::runtime_error(fmt::format("--out {}: {}", out.string(), why));
  };
  std::error_code trouble;
  if (fs::is_directory(out, trouble))
    refuse("is a folder; give the name of a file");
  const fs::path folder = out.has_parent_path() ? out.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, trouble))
    refuse(fmt::format("there is no folder {}", folder.string()));
  const bool exists = fs::exists(out, trouble);
  if (access((exists ? out : folder).c_str(), W_OK) != 0)
    refuse(fmt::format("no permission to write {}", exists ? "to it" : "in its folder"));
}

} // namespace tremolo::app
