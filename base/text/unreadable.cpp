#include "base/text/unreadable.hpp"

#include <unistd.h>

#include <system_error>

namespace tremolo {

std::string why_unreadable(const std::filesystem::path& file) {
  std::error_code trouble;
  const auto status = std::filesystem::status(file, trouble);
  switch (status.type()) {
  case std::filesystem::file_type::regular:
    return ::access(file.c_str(), R_OK) == 0 ? "" : "cannot be read: no permission";
  case std::filesystem::file_type::directory:
    return "cannot be read: this is a folder; give the file in it";
  case std::filesystem::file_type::none:
    return "cannot be read: " + trouble.message();
  case std::filesystem::file_type::not_found:
    return "there is no such file";
  default:
    return "cannot be read: not a regular file";
  }
}

} // namespace tremolo
