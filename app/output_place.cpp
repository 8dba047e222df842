#include "app/output_place.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <system_error>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

/// The first part of a path that is there but is no folder, and what it is; empty if there is none.
std::string obstacle(const fs::path& folder) {
  fs::path part;
  for (const auto& name : folder) {
    part /= name;
    std::error_code trouble;
    if (fs::is_directory(part, trouble))
      continue;
    if (fs::is_symlink(fs::symlink_status(part, trouble)))
      return fmt::format("{} is a link to {}, which is no folder", part.string(),
                         fs::read_symlink(part, trouble).string());
    return fs::exists(part, trouble) ? fmt::format("{} is no folder", part.string()) : "";
  }
  return "";
}

} // namespace

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

bool make_folder(const fs::path& folder) {
  std::error_code trouble;
  const bool made = fs::create_directories(folder, trouble);
  if (!trouble)
    return made;
  const auto reason = obstacle(folder);
  throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder.string(),
                                       reason.empty() ? trouble.message() : reason));
}

} // namespace tremolo::app
