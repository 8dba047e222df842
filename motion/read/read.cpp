#include "motion/read/read.hpp"

#include "base/text/unreadable.hpp"
#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

namespace tremolo::motion {

namespace {

/// A header is recognised by what stands in these.
constexpr std::size_t most_header_lines = 64;

void rewind(std::istream& stream) {
  stream.clear();
  stream.seekg(0);
}

Head head_of(std::istream& stream, const std::filesystem::path& file) {
  Head head{.file = file, .lines = {}};
  Lines lines(stream, file);
  while (lines.number() < most_header_lines && lines.next())
    head.lines.push_back(lines.text());
  rewind(stream);
  return head;
}

/// The first bytes of a file, enough to recognise a binary format; the stream is then again at its start.
std::string first_bytes(std::istream& stream) {
  std::string bytes(512, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  rewind(stream);
  return bytes;
}

bool is_hdf5(std::string_view head) {
  return head.starts_with("\x89HDF\r\n\x1a\n");
}

} // namespace

Record parse_record(std::istream& stream, const std::filesystem::path& file, const ReadAs& as) {
  const Head head = head_of(stream, file);
  const Format& format =
      *std::ranges::find_if(formats(), [&](const Format& one) { return one.recognises(head); });
  if (format.read == nullptr)
    throw RecordError(fmt::format("{}: {}: {}", file.string(), format.name, format.instead));
  if (!as.column.empty() && !format.columns)
    throw RecordError(
        fmt::format("{}: {}: no table of columns; --component chooses", file.string(), format.name));
  if (!as.component.empty() && format.columns)
    throw RecordError(fmt::format("{}: a table; --column chooses", file.string()));
  Lines lines(stream, file);
  return chosen(format.read(lines, as), format.name, file, as, format.peer_units);
}

Record read_record(const std::filesystem::path& file, const ReadAs& as) {
  if (const auto why = why_unreadable(file); !why.empty())
    throw RecordError(fmt::format("{}: {}", file.string(), why));
  std::ifstream stream(file, std::ios::binary);
  const std::string head = first_bytes(stream);
  if (is_hdf5(head)) {
    if (!as.column.empty() || !as.component.empty())
      throw RecordError(fmt::format("{}: HDF5: one motion, without columns or components", file.string()));
    return read_hdf5(file, as);
  }
  if (const auto binary = binary_format(head); !binary.empty())
    throw RecordError(
        fmt::format("{}: {}: binary data, which are not read; write the samples as text, a line "
                    "each of time and value below a header that names the unit",
                    file.string(), binary));
  return parse_record(stream, file, as);
}

} // namespace tremolo::motion
