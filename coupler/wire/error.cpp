#include "coupler/wire/error.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <new>

namespace tremolo::coupler {

std::string message_of(const std::exception& error) {
  if (const auto* files = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
    return fmt::format("{}: {}", files->path1().empty() ? "the working folder" : files->path1().string(),
                       files->code().message());
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "there is not enough memory";
  return error.what();
}

} // namespace tremolo::coupler
