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

/// Bytes of the text, and what stands there instead.
struct Replacement {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string value;
};

/// A pair of key and value as it stands in the text, with what parted it from its neighbours: the comma
/// before it, or after it where it opens an inline table; outside of one the line, unless a comment ends it.
Replacement without_pair(std::string_view text, std::size_t key, std::size_t value_end) {
  constexpr std::string_view blank = " \t\r";
  const auto past_blanks = [&](std::size_t at) {
    return std::min(text.find_first_not_of(blank, at), text.size());
  };
  const auto before = text.find_last_of(",{\n", key); // a dotted key may begin before its last part
  if (before != std::string_view::npos && text[before] == ',')
    return {before, value_end, ""};
  const auto begin = before == std::string_view::npos ? 0 : before + 1;
  auto end = past_blanks(value_end);
  if (before != std::string_view::npos && text[before] == '{')
    return {past_blanks(begin), end < text.size() && text[end] == ',' ? past_blanks(end + 1) : value_end, ""};
  if (end < text.size() && text[end] == '\n')
    ++end;
  return {begin, end, ""};
}

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
    const auto line = scene_.text.find_last_of(",{\n", begin == 0 ? 0 : begin - 1);
    const auto first = scene_.text.find_first_not_of(" \t\r,{\n", line == std::string::npos ? 0 : line);
    const std::string prefix = scene_.text.substr(first, begin - first);
    const bool in_line = line != std::string::npos && scene_.text[line] != '\n';
    for (const auto& [name, text] : more)
      value += fmt::format("{}{}{} = {}", in_line ? ", " : "\n", prefix, name, text);
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
    // From the end, so that earlier positions stay where they are.
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
