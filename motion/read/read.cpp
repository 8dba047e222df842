#include "motion/read/read.hpp"

#include "base/unreadable.hpp"
#include "motion/read/read_formats.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string_view>

namespace tremolo::motion {

namespace {

/// A header is at most this long.
constexpr std::size_t most_header_lines = 50;

bool has_peer_header(std::istream& stream, const std::filesystem::path& file) {
  Lines lines(stream, file);
  while (lines.number() < most_header_lines && lines.next())
    if (peer_header(lines.text()))
      return true;
  return false;
}

bool is_peer(std::istream& stream, const std::filesystem::path& file) {
  const std::string extension = upper(file.extension().string());
  if (extension == ".CSV")
    return false;
  if (extension == ".AT2" || extension == ".VT2" || extension == ".DT2")
    return true;
  const bool found = has_peer_header(stream, file);
  stream.clear();
  stream.seekg(0);
  return found;
}

bool is_hdf5(std::istream& stream) {
  constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
  std::array<char, signature.size()> begin{};
  stream.read(begin.data(), begin.size());
  const bool found = stream && std::string_view(begin.data(), begin.size()) == signature;
  stream.clear();
  stream.seekg(0);
  return found;
}

} // namespace

Record parse_record(std::istream& stream, const std::filesystem::path& file, const ReadAs& as) {
  const bool peer = is_peer(stream, file);
  Lines lines(stream, file);
  return peer ? read_peer(lines, as) : read_table(lines, as);
}

Record read_record(const std::filesystem::path& file, const ReadAs& as) {
  if (const auto why = why_unreadable(file); !why.empty())
    throw RecordError(fmt::format("{}: {}", file.string(), why));
  std::ifstream stream(file, std::ios::binary);
  if (is_hdf5(stream))
    return read_hdf5(file, as);
  return parse_record(stream, file, as);
}

} // namespace tremolo::motion
