#include "base/text/text_file.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace tremolo {
namespace {

constexpr std::size_t most_waiting = std::size_t{1} << 16;

[[noreturn]] void refuse(const std::filesystem::path& file, int reason) {
  throw std::runtime_error(
      fmt::format("cannot write {}: {}", file.string(),
                  reason == ENXIO ? "nobody reads this pipe" : std::generic_category().message(reason)));
}

/// Opened without waiting for the other end of a pipe, but written like any file.
int opened(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NONBLOCK, 0666);
  if (descriptor < 0 || ::fcntl(descriptor, F_SETFL, 0) < 0)
    refuse(file, errno);
  return descriptor;
}

} // namespace

TextFile::TextFile(std::filesystem::path file) : file_(std::move(file)), descriptor_(opened(file_)) {}

TextFile::~TextFile() {
  if (descriptor_ >= 0)
    ::close(descriptor_);
}

void TextFile::add(std::string_view text) {
  waiting_ += text;
  if (waiting_.size() >= most_waiting)
    write_waiting();
}

void TextFile::close() {
  write_waiting();
  if (::close(std::exchange(descriptor_, -1)) != 0)
    refuse(file_, errno);
}

void TextFile::write_waiting() {
  for (std::string_view rest = waiting_; !rest.empty();) {
    const auto count = ::write(descriptor_, rest.data(), rest.size());
    if (count < 0 && errno != EINTR)
      refuse(file_, errno);
    rest.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
  }
  waiting_.clear();
}

void write_text_file(const std::filesystem::path& file, std::string_view text) {
  TextFile whole(file);
  whole.add(text);
  whole.close();
}

std::string read_text_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.good() && !in.eof())
    throw std::runtime_error(fmt::format("cannot read {}", file.string()));
  return text;
}

} // namespace tremolo
