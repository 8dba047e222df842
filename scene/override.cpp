#include "scene/override.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace tremolo::scene {

namespace {

/// Byte offset of a position; columns count characters of UTF-8.
std::size_t offset(std::string_view text, toml::source_position position) {
  std::size_t at = 0;
  for (toml::source_index line = 1; line < position.line; ++line)
    at = text.find('\n', at) + 1;
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  for (toml::source_index column = 1; column < position.column && at < text.size(); ++column)
    do {
      ++at;
    } while (at < text.size() && continues(text[at]));
  return at;
}

struct Replacement {
  toml::source_region where;
  std::string value;
};

std::string quoted(const std::filesystem::path& path) {
  std::string escaped;
  for (const char c : std::filesystem::absolute(path).lexically_normal().string()) {
    if (c == '"' || c == '\\')
      escaped += '\\';
    escaped += c;
  }
  return fmt::format("\"{}\"", escaped);
}

} // namespace

std::string overridden_text(const Case& scene, const MotionOverride& values) {
  const toml::table root = toml::parse(scene.text);
  std::vector<Replacement> replacements;
  const auto* file = std::get_if<MotionFile>(&scene.motion.source);
  if (values.record && file == nullptr)
    throw std::invalid_argument(
        fmt::format("{}: the motion is a pulse; only the record of a case with [motion] file can be replaced",
                    scene.file.string()));
  if (file != nullptr)
    replacements.push_back(
        {root.at_path("motion.file").node()->source(), quoted(values.record.value_or(file->path))});
  if (values.angle_deg)
    replacements.push_back(
        {root.at_path("motion.angle_deg").node()->source(), fmt::format("{}", *values.angle_deg)});

  // From the end, so that earlier positions stay where they are.
  std::ranges::sort(replacements, std::greater{},
                    [&](const Replacement& r) { return offset(scene.text, r.where.begin); });
  std::string text = scene.text;
  for (const auto& [where, value] : replacements) {
    const auto begin = offset(scene.text, where.begin);
    text.replace(begin, offset(scene.text, where.end) - begin, value);
  }
  return text;
}

} // namespace tremolo::scene
