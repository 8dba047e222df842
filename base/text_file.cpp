#include "results/text_file.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace tremolo::results {
namespace {

/// Whether all of the text has reached the system; errno says why not.
bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const auto count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno != EINTR) {
      return false;
    }
    text.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
  }
  return true;
}

} // namespace

void write_text_file(const std::filesystem::path& file, std::string_view text) {
  const auto refuse = [&] {
    throw std::runtime_error(
        fmt::format("cannot write {}: {}", file.string(), std::generic_category().message(errno)));
  };
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    refuse();
  }
  if (!write_all(descriptor, text)) {
    const int reason = errno;
    ::close(descriptor);
    errno = reason;
    refuse();
  }
  if (::close(descriptor) != 0) {
    refuse();
  }
}

} // namespace tremolo::results
