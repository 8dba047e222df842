#include "results/xdmf.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <stdexcept>
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

[[noreturn]] void throw_system_error(const std::filesystem::path& file, std::string_view action) {
  throw std::runtime_error(
      fmt::format("{}: cannot {}: {}", file.string(), action, std::generic_category().message(errno)));
}

} // namespace

XdmfFile::XdmfFile(const std::filesystem::path& run_file)
    : file_(std::filesystem::path(run_file).replace_extension(".xdmf")),
      heavy_data_(xml_escaped(run_file.filename().string())) {
  replace();
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
  frames_ += fmt::format("      <Grid Name=\"particles\">\n        <Time Value=\"{:.17g}\"/>\n"
                         "        <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\"/>\n",
                         time, particles);
  for (const XdmfField& field : fields) {
    if (field.name == "position") {
      frames_ += fmt::format("        <Geometry GeometryType=\"XY\">{}</Geometry>\n", item(field));
    } else {
      frames_ +=
          fmt::format("        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">{}</Attribute>\n",
                      xml_escaped(field.name), field.components == 1 ? "Scalar" : "Matrix", item(field));
    }
  }
  frames_ += "      </Grid>\n";
  replace();
}

void XdmfFile::replace() const {
  std::filesystem::path draft = file_;
  draft += ".part";
  const std::string text =
      fmt::format("<?xml version=\"1.0\"?>\n"
                  "<Xdmf Version=\"2.0\">\n  <Domain>\n"
                  "    <Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n"
                  "{}    </Grid>\n  </Domain>\n</Xdmf>\n",
                  frames_);
  errno = 0;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(draft.c_str(), "wb"), std::fclose);
  if (!out) {
    throw_system_error(draft, "create the XDMF file");
  }
  const bool written = std::fwrite(text.data(), 1, text.size(), out.get()) == text.size();
  if (std::fclose(out.release()) != 0 || !written) {
    throw_system_error(draft, "write the XDMF file");
  }
  std::error_code error;
  std::filesystem::rename(draft, file_, error);
  if (error) {
    throw std::runtime_error(
        fmt::format("{}: cannot replace the XDMF file: {}", file_.string(), error.message()));
  }
}

} // namespace tremolo::results
