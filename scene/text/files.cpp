#include "scene/text/files.hpp"

#include <algorithm>
#include <string_view>

namespace tremolo::scene {

namespace fs = std::filesystem;

std::vector<fs::path> data_files(const Case& scene) {
  std::vector<fs::path> files;
  const auto add = [&](const fs::path& file) {
    const auto name = fs::absolute(file).lexically_normal();
    if (std::ranges::find(files, name) == files.end())
      files.push_back(name);
  };
  for (const auto& [record, path] : scene.records())
    add(record->path);
  for (const FreeFieldModel* field :
       {&scene.boundary.left.field, &scene.boundary.right.field, &scene.boundary.base.field})
    if (field->model == SourceModel::recording)
      add(field->file);
  for (const auto& [key, value, origin] : scene.values) {
    if (!key.starts_with("soil.") || !key.ends_with(".curve"))
      continue;
    if (const auto name = value.substr(1, value.size() - 2); name != built_in_curve) // in quotes
      add(scene.directory / name);
  }
  return files;
}

} // namespace tremolo::scene
