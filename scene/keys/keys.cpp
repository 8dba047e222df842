#include "scene/keys/keys.hpp"

#include "scene/keys/keys_field.hpp"
#include "scene/keys/keys_hosts.hpp"
#include "scene/keys/keys_model.hpp"
#include "scene/keys/keys_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::scene {

const Key* Table::find(std::string_view key) const {
  const auto found = std::ranges::find(keys, key, &Key::name);
  return found == keys.end() ? nullptr : &*found;
}

KeyTable case_keys() {
  static const std::vector<Table> tables = [] {
    std::vector<Table> all = {{.name = "",
                               .meaning = "Keys at the top of the file, before the first table.",
                               .keys = {{.name = "title",
                                         .type = Type::text,
                                         .meaning = "One line that names the case.",
                                         .required = true}}}};
    for (const auto& group :
         {field_keys(), boundary_keys(), numerics_keys(), model_keys(), run_keys(), hosts_keys()})
      all.insert(all.end(), group.begin(), group.end());
    return all;
  }();
  return tables;
}

const Table& table_spec(KeyTable keys, std::string_view name) {
  const auto found = std::ranges::find(keys, name, &Table::name);
  if (found == keys.end())
    throw std::logic_error(fmt::format("no table '{}' in the key table", name));
  return *found;
}

std::vector<std::string_view> subtables(KeyTable keys, std::string_view parent) {
  std::vector<std::string_view> names;
  for (const Table& table : keys) {
    const auto dot = table.name.rfind('.');
    const auto above = dot == std::string_view::npos ? std::string_view{} : table.name.substr(0, dot);
    if (!table.name.empty() && above == parent)
      names.push_back(table.name.substr(dot == std::string_view::npos ? 0 : dot + 1));
  }
  return names;
}

std::string type_text(const Key& key) {
  switch (key.type) {
  case Type::text:
    return "string";
  case Type::number:
    return key.over_depth ? "number or profile" : "number";
  case Type::integer:
    return "integer";
  case Type::choice:
    return "string";
  case Type::choice_by_name:
    return "string, or table { NAME = string }";
  case Type::texts:
  case Type::choices:
    return "array of strings";
  case Type::boolean:
    return "boolean";
  case Type::numbers:
    return fmt::format("array of {} numbers {}", key.count, key.form);
  case Type::numbers_or_false:
    return fmt::format("array of {} numbers {} or false", key.count, key.form);
  case Type::series:
    return "number or array of numbers";
  case Type::polygon:
    return "array of at least 3 points [[x, y], ...]";
  case Type::line:
    return "array of at least 2 points [[x, y], ...]";
  case Type::points:
    return "array of at least 1 point [[x, y], ...]";
  }
  return {};
}

} // namespace tremolo::scene
