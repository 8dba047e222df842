#include "scene/text/set_value.hpp"

#include "scene/text/text_edit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tremolo::scene {

namespace {

/// "boundary.base" and "form" of "boundary.base.form".
struct Path {
  std::string table;
  std::string key;
};

Path path_of(const std::string& key) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-.[]").find(c) != std::string_view::npos;
  };
  const auto dot = key.rfind('.');
  if (key.empty() || key.back() == '.' || key.back() == ']' || dot == 0 || !std::ranges::all_of(key, allowed))
    throw std::invalid_argument(
        fmt::format("'{}' is not a key of a case: write it as mesh.size or region[0].soil", key));
  return dot == std::string::npos ? Path{"", key} : Path{key.substr(0, dot), key.substr(dot + 1)};
}

/// A pair of key and value of a table, where they stand in the text.
struct Pair {
  std::size_t key = 0;
  std::size_t value = 0;
  std::size_t end = 0;
};

Pair place(std::string_view text, const toml::key& name, const toml::node& node) {
  return {offset(text, name.source().begin), offset(text, node.source().begin),
          offset(text, node.source().end)};
}

/// The last pair of a table that is written as one, not as a table under a heading of its own.
std::optional<Pair> last_pair(std::string_view text, const toml::table& table) {
  std::optional<Pair> last;
  for (auto&& [name, node] : table) {
    const Pair pair = place(text, name, node);
    if (pair.value > pair.key && (!last || pair.key > last->key))
      last = pair;
  }
  return last;
}

std::string with_table(std::string_view text, const Path& path, const std::string& value) {
  return fmt::format("{}{}\n[{}]\n{} = {}\n", text, text.ends_with('\n') ? "" : "\n", path.table, path.key,
                     value);
}

} // namespace

std::string toml_value(std::string_view text) {
  try {
    const toml::table table = toml::parse(fmt::format("value = {}", text));
    if (table.size() == 1)
      return std::string(text);
  } catch (const toml::parse_error&) {
    // A bare word.
  }
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      quoted += '\\';
    if (c == '\n')
      quoted += "\\n";
    else
      quoted += c;
  }
  return quoted + '"';
}

std::string with_value(std::string_view text, const std::string& key,
                       const std::optional<std::string>& value) {
  const Path path = path_of(key);
  toml::table root = toml::parse(text);
  const toml::node* node = path.table.empty() ? &root : root.at_path(path.table).node();
  const auto replaced = [&](std::size_t begin, std::size_t end, std::string_view by) {
    return std::string(text).replace(begin, end - begin, by);
  };
  if (node == nullptr && path.table.find('[') == std::string::npos)
    return value ? with_table(text, path, *value) : std::string(text);
  if (node == nullptr || !node->is_table())
    throw std::invalid_argument(fmt::format("{}: the case has no table {}", key, path.table));
  const toml::table& table = *node->as_table();
  if (const auto found = table.find(path.key); found != table.end()) {
    const Pair pair = place(text, found->first, found->second);
    if (pair.value <= pair.key)
      throw std::invalid_argument(fmt::format("{} is a table: name one of its keys", key));
    if (value)
      return replaced(pair.value, pair.end, *value);
    const Replacement without = without_pair(text, pair.key, pair.end);
    return replaced(without.begin, without.end, without.value);
  }
  if (!value)
    return std::string(text);
  const auto beside = last_pair(text, table);
  if (!beside)
    throw std::invalid_argument(
        fmt::format("{}: [{}] of the case is empty, write a key into it first", key, path.table));
  return replaced(beside->end, beside->end,
                  fmt::format("{}{} = {}", separator_after(text, beside->key), path.key, *value));
}

} // namespace tremolo::scene
