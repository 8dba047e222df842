#include "scene/read/reader.hpp"

#include "base/text/printable.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

Place place_of(const toml::node& node, std::string shown) {
  return {node.source().begin.line, node.source().begin.column, std::move(shown)};
}

/// The tables of an array.
std::vector<TableReader> read_tables(const toml::node& node, const Table& spec, const std::string& path,
                                     Reading reading) {
  std::vector<TableReader> readers;
  const std::string shown = fmt::format("[{}]", spec.name);
  reading.findings.locate(path, place_of(node, shown));
  const toml::array* array = node.as_array();
  if (array == nullptr) {
    reading.findings.add(path, fmt::format("'{0}' must be an array of tables, found {1}: write [[{0}]]",
                                           spec.name, type_name(node)));
    return readers;
  }
  std::size_t index = 0;
  for (const toml::node& element : *array) {
    const std::string of_element = fmt::format("{}[{}]", path, index++);
    reading.findings.locate(of_element, place_of(element, shown));
    if (!element.is_table())
      reading.findings.add(
          of_element, fmt::format("each [[{}]] must be a table, found {}", spec.name, type_name(element)));
    readers.emplace_back(spec, element.as_table(), of_element, shown, reading);
  }
  return readers;
}

} // namespace

std::optional<TableReader> TableReader::table(std::string_view key) const {
  const toml::node* node = node_ != nullptr ? node_->get(key) : nullptr;
  if (node == nullptr)
    return std::nullopt;
  const Table& spec = table_spec(reading_.keys, fmt::format("{}.{}", spec_.name, key));
  const std::string shown(node->is_table() ? spec.name : shown_);
  reading_.findings.locate(path(key), place_of(*node, shown));
  if (!node->is_table())
    reading_.findings.add(path(key), fmt::format("'{}' must be a table, found {}", key, type_name(*node)));
  return TableReader{spec, node->as_table(), path(key), shown, reading_};
}

std::vector<TableReader> TableReader::tables(std::string_view key) const {
  const toml::node* node = node_ != nullptr ? node_->get(key) : nullptr;
  if (node == nullptr)
    return {};
  return read_tables(*node, table_spec(reading_.keys, fmt::format("{}.{}", spec_.name, key)), path(key),
                     reading_);
}

TableReader Document::table(std::string_view name) {
  const Table& spec = table_spec(reading_.keys, name);
  const std::string shown(name);
  const toml::node* node = name.empty() ? &root_ : root_.at_path(name).node();
  if (node == nullptr) {
    if (spec.required)
      reading_.findings.add(shown, fmt::format("missing table [{}]: {}", name, spec.meaning));
    return {spec, nullptr, shown, shown, reading_};
  }
  reading_.findings.locate(shown, place_of(*node, shown));
  if (!node->is_table())
    reading_.findings.add(
        shown, fmt::format("'{}' must be a table, found {}: write [{}]", name, type_name(*node), name));
  return {spec, node->as_table(), shown, shown, reading_};
}

std::vector<TableReader> Document::array(std::string_view name) {
  const Table& spec = table_spec(reading_.keys, name);
  const toml::node* node = root_.at_path(name).node();
  const toml::array* array = node != nullptr ? node->as_array() : nullptr;
  if (node == nullptr || (array != nullptr && array->empty())) {
    if (spec.required)
      reading_.findings.add(std::string(name), fmt::format("missing table [[{}]]: {}", name, spec.meaning));
    return {};
  }
  return read_tables(*node, spec, std::string(name), reading_);
}

std::vector<NamedTable> Document::named(std::string_view name) {
  const Table& spec = table_spec(reading_.keys, name);
  std::vector<NamedTable> readers;
  const toml::node* node = root_.get(name);
  const toml::table* table = node != nullptr ? node->as_table() : nullptr;
  if (node == nullptr || (table != nullptr && table->empty())) {
    if (spec.required)
      reading_.findings.add(std::string(name),
                            fmt::format("missing table [{}.NAME]: {}", name, spec.meaning));
    return readers;
  }
  reading_.findings.locate(std::string(name), place_of(*node, std::string(name)));
  if (table == nullptr) {
    reading_.findings.add(
        std::string(name),
        fmt::format("'{0}' must be a table of tables, found {1}: write [{0}.NAME]", name, type_name(*node)));
    return readers;
  }
  for (const auto& [key, element] : *table) {
    const std::string path = fmt::format("{}.{}", name, key.str());
    reading_.findings.locate(path, place_of(element, path));
    if (!is_printable_line(key.str()))
      reading_.findings.add(path,
                            "the name holds a control character or the end of a line, must be plain text");
    if (!element.is_table()) {
      reading_.findings.add(path, fmt::format("'{}' must be a table, found {}: write [{}]", key.str(),
                                              type_name(element), path));
      continue;
    }
    readers.push_back({std::string(key.str()), {spec, element.as_table(), path, path, reading_}});
  }
  return readers;
}

} // namespace tremolo::scene
