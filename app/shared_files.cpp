#include "app/shared_files.hpp"

namespace tremolo::app {

namespace fs = std::filesystem;

fs::path shared_folder(const char* name) {
  const fs::path installed = fs::canonical("/proc/self/exe").parent_path() / "../share/tremolo" / name;
  return fs::exists(installed) ? installed.lexically_normal() : fs::path(TREMOLO_SOURCE) / name;
}

} // namespace tremolo::app
