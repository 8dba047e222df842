#include "scene/rules/rules.hpp"

#include "base/text/unreadable.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <string>
#include <string_view>

namespace tremolo::scene {

namespace {

/// Every such file begins with these eight bytes.
bool is_hdf5(const std::filesystem::path& file) {
  constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
  std::array<char, signature.size()> begin{};
  std::ifstream stream(file, std::ios::binary);
  return stream.read(begin.data(), begin.size()) && std::string_view(begin.data(), begin.size()) == signature;
}

} // namespace

void model_files_exist(const Case& scene, Findings& findings) {
  const auto check = [&](const FreeFieldModel& field, const std::string& side) {
    const bool program = field.model == SourceModel::external;
    if (!program && field.model != SourceModel::recording)
      return;
    const std::string path = fmt::format("boundary.{}.{}", side, program ? "program" : "file");
    if (!findings.sound(path))
      return;
    std::error_code trouble;
    const bool file = std::filesystem::is_regular_file(field.file, trouble);
    if (const auto why = why_unreadable(field.file); !why.empty() && !(program && file))
      findings.add(path, fmt::format("'{}': {}", field.file.string(), why));
    else if (!program && !is_hdf5(field.file))
      findings.add(path, fmt::format("'{}' is no recording: not a file of HDF5", field.file.string()));
    else if (program && access(field.file.c_str(), X_OK) != 0)
      findings.add(path, fmt::format("'{}' is not a program that may be run", field.file.string()));
  };
  check(scene.boundary.left.field, "left");
  check(scene.boundary.right.field, "right");
  check(scene.boundary.base.field, "base");
}

} // namespace tremolo::scene
