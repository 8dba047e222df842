#include "results/frames/xdmf.hpp"

#include "base/text/text_file.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

namespace tremolo::results {
namespace {

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    default:
      out += c;
    }
  }
  return out;
}

constexpr std::string_view head =
    "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n  <Domain>\n"
    "    <Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
constexpr std::string_view tail = "    </Grid>\n  </Domain>\n</Xdmf>\n";

[[noreturn]] void throw_system_error(const std::filesystem::path& file) {
  throw std::runtime_error(fmt::format("{}: cannot write the XDMF file: {}", file.string(),
                                       std::generic_category().message(errno)));
}

bool written(int descriptor, std::string_view text, std::uintmax_t at) {
  return ::pwrite(descriptor, text.data(), text.size(), static_cast<off_t>(at)) ==
         static_cast<ssize_t>(text.size());
}

/// Replaces what follows a place of the file. Where that fails, the file ends there as it did before.
void write_end(const std::filesystem::path& file, std::string_view text, std::uintmax_t at) {
  errno = 0;
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) {
    throw_system_error(file);
  }
  const bool whole = written(descriptor, text, at);
  const int reason = errno;
  if (!whole && written(descriptor, tail, at)) {
    std::error_code ignored;
    std::filesystem::resize_file(file, at + tail.size(), ignored);
  }
  if (::close(descriptor) != 0 || !whole) {
    errno = whole ? errno : reason;
    throw_system_error(file);
  }
}

} // namespace

XdmfFile::XdmfFile(const std::filesystem::path& run_file)
    : file_(std::filesystem::path(run_file).replace_extension(".xdmf")),
      heavy_data_(xml_escaped(run_file.filename().string())), end_(head.size()) {
  write_text_file(file_, fmt::format("{}{}", head, tail));
}

void XdmfFile::add_frame(double time, std::string_view group, std::size_t particles,
                         std::span<const XdmfField> fields) {
  const auto item = [&](const XdmfField& field) {
    const std::string shape =
        field.components == 1 ? std::to_string(particles) : fmt::format("{} {}", particles, field.components);
    return fmt::format(
        R"(<DataItem Format="HDF" Dimensions="{}" NumberType="{}" Precision="{}">{}:{}/{}</DataItem>)", shape,
        field.real ? "Float" : "Int", field.real ? 8 : 4, heavy_data_, group, xml_escaped(field.name));
  };
  std::string grid = fmt::format("      <Grid Name=\"particles\">\n        <Time Value=\"{:.17g}\"/>\n"
                                 "        <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\"/>\n",
                                 time, particles);
  for (const XdmfField& field : fields) {
    if (field.name == "position") {
      grid += fmt::format("        <Geometry GeometryType=\"XY\">{}</Geometry>\n", item(field));
    } else {
      grid +=
          fmt::format("        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">{}</Attribute>\n",
                      xml_escaped(field.name), field.components == 1 ? "Scalar" : "Matrix", item(field));
    }
  }
  grid += "      </Grid>\n";
  write_end(file_, grid + std::string(tail), end_);
  end_ += grid.size();
}

} // namespace tremolo::results
