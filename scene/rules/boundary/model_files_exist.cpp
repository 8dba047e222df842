#include "scene/rules/rules.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <string>

namespace tremolo::scene {

void model_files_exist(const Case& scene, Findings& findings) {
  const auto check = [&](const FreeFieldModel& field, const std::string& side) {
    const bool program = field.model == SourceModel::external;
    if (!program && field.model != SourceModel::recording)
      return;
    const std::string path = fmt::format("boundary.{}.{}", side, program ? "program" : "file");
    if (!findings.sound(path))
      return;
    std::error_code trouble;
    if (!std::filesystem::is_regular_file(field.file, trouble))
      findings.add(path, fmt::format("'{}': there is no such file", field.file.string()));
    else if (program && access(field.file.c_str(), X_OK) != 0)
      findings.add(path, fmt::format("'{}' is not a program that may be run", field.file.string()));
  };
  check(scene.boundary.left.field, "left");
  check(scene.boundary.right.field, "right");
  check(scene.boundary.base.field, "base");
}

} // namespace tremolo::scene
