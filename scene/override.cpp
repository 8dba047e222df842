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

/// All replacements of a text that is being overridden.
class Replacements {
public:
  explicit Replacements(const Case& scene) : scene_(scene), root_(toml::parse(scene.text)) {}

  void put(const std::string& key, std::string value) {
    replacements_.push_back({root_.at_path(key).node()->source(), std::move(value)});
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
    // From the end, so that earlier positions stay where they are.
    std::ranges::sort(replacements_, std::greater{},
                      [&](const Replacement& r) { return offset(scene_.text, r.where.begin); });
    std::string text = scene_.text;
    for (const auto& [where, value] : replacements_) {
      const auto begin = offset(scene_.text, where.begin);
      text.replace(begin, offset(scene_.text, where.end) - begin, value);
    }
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
  const auto* file = std::get_if<MotionFile>(&scene.motion.source);
  if (values.record && file == nullptr)
    throw std::invalid_argument(
        fmt::format("{}: the motion is a pulse; only the record of a case with [motion] file can be replaced",
                    scene.file.string()));
  if (file != nullptr)
    replacements.put("motion.file", quoted(values.record.value_or(file->path)));
  if (values.angle_deg)
    replacements.put("motion.angle_deg", fmt::format("{}", *values.angle_deg));
  for (const Side side : {Side::left, Side::right, Side::base}) {
    const auto boundary = fmt::format("boundary.{}", name(side));
    if (values.model)
      replacements.put(boundary + ".model", fmt::format("\"{}\"", name(*values.model)));
    replacements.put_absolute(boundary + ".file");
    replacements.put_absolute(boundary + ".program");
  }
  replacements.put_absolute_curves();
  return std::move(replacements).text();
}

} // namespace tremolo::scene
