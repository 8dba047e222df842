#include "scene/read/override.hpp"

#include "scene/text/text_edit.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace tremolo::scene {

namespace {

std::string quoted(const std::filesystem::path& path) {
  std::string escaped;
  for (const char c : std::filesystem::absolute(path).lexically_normal().string()) {
    if (c == '"' || c == '\\')
      escaped += '\\';
    escaped += c;
  }
  return fmt::format("\"{}\"", escaped);
}

/// All replacements of a text that is being overridden.
class Replacements {
public:
  explicit Replacements(const Case& scene) : scene_(scene), root_(toml::parse(scene.text)) {}

  void put(const std::string& key, std::string value) {
    const auto& where = root_.at_path(key).node()->source();
    replacements_.push_back(
        {offset(scene_.text, where.begin), offset(scene_.text, where.end), std::move(value)});
  }

  /// Adds keys to a table behind one that it has, as that one is written: in an inline table, in lines of
  /// their own, or dotted.
  void put_with(const std::string& table, const std::string& key, std::string value,
                const std::vector<std::pair<std::string, std::string>>& more) {
    const auto& keys = *root_.at_path(table).as_table();
    const auto begin = offset(scene_.text, keys.find(key)->first.source().begin);
    const std::string separator = separator_after(scene_.text, begin);
    for (const auto& [name, text] : more)
      value += fmt::format("{}{} = {}", separator, name, text);
    put(fmt::format("{}.{}", table, key), std::move(value));
  }

  /// Removes a key of a table, where it has it.
  void remove(const std::string& table, std::string_view key) {
    for (auto&& [name, node] : *root_.at_path(table).as_table())
      if (name == key)
        replacements_.push_back(without_pair(scene_.text, offset(scene_.text, name.source().begin),
                                             offset(scene_.text, node.source().end)));
  }

  /// The file name under a key, where the case has one, made absolute.
  void put_absolute(const std::string& key) {
    if (const auto* name = root_.at_path(key).as_string())
      put(key, quoted(scene_.directory / name->get()));
  }

  /// Fitted curves are tables in files, or built in.
  void put_absolute_curves() {
    for (const Soil& soil : scene_.soils) {
      const auto key = fmt::format("soil.{}.curve", soil.name);
      if (const auto* name = root_.at_path(key).as_string(); name != nullptr && name->get() != built_in_curve)
        put_absolute(key);
    }
  }

  std::string text() && {
    // Edits are applied from the end, so that earlier positions stay valid.
    std::ranges::sort(replacements_, std::greater{}, &Replacement::begin);
    std::string text = scene_.text;
    for (const auto& [begin, end, value] : replacements_)
      text.replace(begin, end - begin, value);
    return text;
  }

private:
  const Case& scene_;
  toml::table root_;
  std::vector<Replacement> replacements_;
};

} // namespace

std::string overridden_text(const Case& scene, const CaseOverride& values) {
  Replacements replacements(scene);
  const auto* file = std::get_if<MotionFile>(&scene.motion.shakings.front().source);
  if (values.record && file == nullptr)
    throw std::invalid_argument(
        fmt::format("{}: the motion is a pulse; only the record of a case with [motion] file can be replaced",
                    scene.file.string()));
  if (file != nullptr)
    replacements.put("motion.file", quoted(values.record.value_or(file->path)));
  for (const auto& [later, path] : scene.records())
    if (later != file)
      replacements.put(path + ".file", quoted(later->path));
  if (values.angle_deg)
    replacements.put("motion.angle_deg", fmt::format("{}", *values.angle_deg));
  for (const Side side : {Side::left, Side::right, Side::base}) {
    if (!scene.boundary.has_lateral_fields() && side != Side::base)
      continue;
    const auto boundary = fmt::format("boundary.{}", name(side));
    const auto replay = values.replays.find(side);
    const bool replayed = replay != values.replays.end();
    if (replayed)
      replacements.put_with(boundary, "model", "\"recording\"",
                            {{"file", quoted(replay->second.file)},
                             {"side", fmt::format("\"{}\"", name(replay->second.side))}});
    else if (values.model)
      replacements.put(boundary + ".model", fmt::format("\"{}\"", name(*values.model)));
    for (const char* key : {"file", "program", "side"})
      if (replayed || values.model)
        replacements.remove(boundary, key);
    if (!replayed && !values.model)
      for (const char* key : {"file", "program"})
        replacements.put_absolute(fmt::format("{}.{}", boundary, key));
  }
  replacements.put_absolute_curves();
  return std::move(replacements).text();
}

} // namespace tremolo::scene
