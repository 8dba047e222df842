#include "scene/read/reader.hpp"

#include "base/text/printable.hpp"
#include "base/text/unit_text.hpp"
#include "scene/soils/soil_library.hpp"
#include "scene/text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace tremolo::scene {

std::string type_name(const toml::node& node) {
  switch (node.type()) {
  case toml::node_type::table:
    return "a table";
  case toml::node_type::array:
    return "an array";
  case toml::node_type::string:
    return "a string";
  case toml::node_type::integer:
    return "an integer";
  case toml::node_type::floating_point:
    return "a number";
  case toml::node_type::boolean:
    return "a boolean";
  default:
    return "a date or time";
  }
}

namespace {

std::string point_text(Point p) {
  return fmt::format("[{}, {}]", p.x, p.y);
}

/// A value as TOML writes it.
struct AsToml {
  std::string operator()(double value) const { return fmt::format("{}", value); }
  std::string operator()(const std::string& value) const { return fmt::format("\"{}\"", value); }
  std::string operator()(const std::vector<double>& value) const {
    return fmt::format("[{}]", fmt::join(value, ", "));
  }
  std::string operator()(const std::vector<std::string>& value) const { return fmt::format("{}", value); }
  std::string operator()(const Polygon& value) const {
    std::string text;
    for (const Point p : value)
      text += (text.empty() ? "" : ", ") + point_text(p);
    return "[" + text + "]";
  }
};

std::vector<std::string> split_list(std::string_view text) {
  std::vector<std::string> items;
  while (!text.empty()) {
    const auto comma = text.find(", ");
    items.emplace_back(text.substr(0, comma));
    text = comma == std::string_view::npos ? "" : text.substr(comma + 2);
  }
  return items;
}

} // namespace

TableReader::TableReader(const Table& spec, const toml::table* node, std::string path, std::string shown,
                         Reading reading)
    : spec_(spec), node_(node), path_(std::move(path)), shown_(std::move(shown)), reading_(reading) {
  if (node_ != nullptr) {
    refuse_unknown_keys();
    find_library();
  }
  // Keys without a condition come first, since the others depend on their values.
  for (const bool conditional : {false, true})
    for (const Key& key : spec_.keys)
      if (key.when.key.empty() != conditional)
        read(key);
}

std::string TableReader::path(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

/// Looks up a key in the file, otherwise in the library's soil.
const toml::node* TableReader::node_of(std::string_view key) const {
  const toml::node* own = node_ != nullptr ? node_->get(key) : nullptr;
  return own == nullptr && library_.table != nullptr ? library_.table->get(key) : own;
}

bool TableReader::given(std::string_view key) const {
  return node_of(key) != nullptr || settled_.contains(key);
}

bool TableReader::varies_over_depth() const {
  return reading_.profiles != nullptr && std::ranges::any_of(spec_.keys, [&](const Key& key) {
           return reading_.profiles->contains(path(key.name));
         });
}

bool TableReader::from_library(std::string_view key) const {
  return node_ != nullptr && !node_->contains(key) && given(key);
}

void TableReader::find_library() {
  const toml::node* name = spec_.find(library_key) != nullptr ? node_->get(library_key) : nullptr;
  if (name == nullptr || !name->is_string())
    return;
  const auto wanted = *name->value<std::string>();
  if (const LibrarySoil* soil = library_soil(wanted)) {
    library_ = {soil->name, soil->keys};
    return;
  }
  const auto begin = name->source().begin;
  reading_.findings.add(
      path(library_key), Place{begin.line, begin.column, shown_},
      fmt::format("'{}' is not in the library of soils, {}", wanted, suggestion(wanted, library_names())));
}

void TableReader::refuse_unknown_keys() {
  auto known = subtables(reading_.keys, spec_.name);
  for (const Key& key : spec_.keys)
    known.push_back(key.name);
  for (const auto& [key, value] : *node_)
    if (std::ranges::find(known, key.str()) == known.end()) {
      const auto begin = key.source().begin;
      reading_.findings.add(path(key.str()), Place{begin.line, begin.column, shown_},
                            fmt::format("unknown key '{}', {}", key.str(), suggestion(key.str(), known)));
    }
}

bool TableReader::applies(const Key& key) const {
  if (key.when.key.empty())
    return true;
  const auto value = get<std::string>(key.when.key);
  return std::ranges::find(key.when.values, value) != key.when.values.end();
}

void TableReader::read(const Key& key) {
  const bool undecided = !key.when.key.empty() && get<std::string>(key.when.key).empty();
  if (!given(key.name)) {
    if (applies(key) && node_ != nullptr && key.required)
      report_missing(key);
    else if (applies(key) && (node_ != nullptr || !key.required))
      put_default(key);
    return;
  }
  const toml::node& node = *node_of(key.name);
  const auto begin = (from_library(key.name) ? *node_->get(library_key) : node).source().begin;
  reading_.findings.locate(path(key.name), {begin.line, begin.column, shown_});
  if (!applies(key) && !undecided) {
    reading_.findings.add(path(key.name), fmt::format("'{}' does not apply to {} = \"{}\", only to {}",
                                                      key.name, key.when.key, get<std::string>(key.when.key),
                                                      fmt::join(key.when.values, " or ")));
    return;
  }
  if (auto value = convert(key, node)) {
    reading_.values.push_back({path(key.name), shown_value(key, *value), origin(key.name, node)});
    values_.emplace(key.name, std::move(*value));
  }
}

/// The value as written in the file.
std::string TableReader::shown_value(const Key& key, const Value& value) const {
  if (key.type == Type::boolean)
    return std::get<std::string>(value);
  if (const auto named = by_name_.find(key.name); named != by_name_.end()) {
    std::string text;
    for (const auto& [name, word] : named->second)
      text += fmt::format("{} {} = \"{}\"", text.empty() ? "" : ",", name, word);
    return fmt::format("{{{} }}", text);
  }
  if (key.over_depth && reading_.profiles != nullptr)
    if (const auto profile = reading_.profiles->find(path(key.name)); profile != reading_.profiles->end())
      return scene::text(profile->second);
  return std::visit(AsToml{}, value);
}

std::string TableReader::origin(std::string_view key, const toml::node& node) const {
  if (from_library(key))
    return fmt::format("library {}", library_.name);
  return fmt::format("{}:{}:{}", reading_.findings.file(), node.source().begin.line,
                     node.source().begin.column);
}

/// With an unknown library no key is reported missing, since the library may define it.
void TableReader::report_missing(const Key& key) {
  if (spec_.find(library_key) != nullptr && !reading_.findings.sound(path(library_key)))
    return;
  reading_.findings.add(
      path(key.name), fmt::format("missing '{}', {}: {}", key.name,
                                  with_unit(type_text(key), key.unit.empty() ? "" : key.unit), key.meaning));
}

void TableReader::put_default(const Key& key) {
  if (key.fallback.empty())
    return;
  Value value = std::string(key.fallback);
  if (key.type == Type::number || key.type == Type::integer) {
    double number = 0.0;
    std::from_chars(key.fallback.data(), key.fallback.data() + key.fallback.size(), number);
    value = number;
  } else if (key.type == Type::choices) {
    value = split_list(key.fallback);
  }
  const bool bare = key.type == Type::boolean;
  reading_.values.push_back(
      {path(key.name), bare ? std::string(key.fallback) : std::visit(AsToml{}, value), "default"});
  values_.emplace(key.name, std::move(value));
}

std::nullopt_t TableReader::refuse(const Key& key, const toml::node& node, std::string text) {
  const auto begin = node.source().begin;
  reading_.findings.add(path(key.name), Place{begin.line, begin.column, shown_}, std::move(text));
  return std::nullopt;
}

std::optional<TableReader::Value> TableReader::convert(const Key& key, const toml::node& node) {
  switch (key.type) {
  case Type::number:
  case Type::integer:
    return convert_number(key, node);
  case Type::text:
  case Type::choice:
    return convert_text(key, node);
  case Type::choice_by_name:
    return convert_choice_by_name(key, node);
  case Type::boolean:
    return convert_boolean(key, node);
  case Type::numbers:
    return convert_numbers(key, node);
  case Type::numbers_or_false:
    if (node.is_boolean() && !*node.value<bool>())
      return std::vector<double>{};
    return convert_numbers(key, node);
  case Type::series:
    return convert_series(key, node);
  case Type::polygon:
    return convert_points(key, node, 3);
  case Type::line:
    return convert_points(key, node, 2);
  case Type::points:
    return convert_points(key, node, 1);
  case Type::texts:
    return convert_texts(key, node);
  case Type::choices:
    return convert_choices(key, node);
  }
  return std::nullopt;
}

std::optional<double> TableReader::convert_number(const Key& key, const toml::node& node) {
  const bool whole = key.type == Type::integer;
  if (const toml::table* profile = node.as_table(); profile != nullptr && !whole)
    return convert_profile(key, *profile);
  if (!node.is_number() || (whole && !node.is_integer()))
    return refuse(key, node,
                  fmt::format("'{}' must be {}, found {}", key.name, whole ? "an integer" : "a number",
                              type_name(node)));
  // toml++ hands out no double for an integer that none equals: the nearest one is meant.
  const toml::value<std::int64_t>* integer = node.as_integer();
  const double value =
      integer != nullptr ? static_cast<double>(integer->get()) : node.as_floating_point()->get();
  if (!std::isfinite(value))
    return refuse(key, node, fmt::format("'{}' is {}, must be a finite number", key.name, value));
  if (!key.range.contains(value))
    return refuse(key, node,
                  fmt::format("'{}' = {} is out of range, must be {}", key.name,
                              integer != nullptr ? std::to_string(integer->get()) : fmt::to_string(value),
                              with_unit(key.range.text(), key.unit)));
  return value;
}

/// The value at the place that is asked for.
std::optional<double> TableReader::convert_profile(const Key& key, const toml::table& node) {
  if (!key.over_depth || reading_.profiles == nullptr) {
    std::vector<std::string_view> varying;
    for (const Key& other : spec_.keys)
      if (other.over_depth && reading_.profiles != nullptr)
        varying.push_back(other.name);
    return refuse(key, node,
                  fmt::format("'{}' must be a number, found a table{}{}", key.name,
                              varying.empty() ? "" : "; over depth can vary ", fmt::join(varying, ", ")));
  }
  const auto profile = read_profile(
      key, node, [&](const toml::node& part, std::string why) { refuse(key, part, std::move(why)); });
  if (!profile)
    return std::nullopt;
  reading_.profiles->insert_or_assign(path(key.name), *profile);
  if (reading_.place == nullptr)
    return typical_value(*profile);
  const auto value = value_at(*profile, *reading_.place);
  if (!value)
    return refuse(
        key, node,
        fmt::format("'{}' follows the vertical effective stress below [surface] level, but the soil "
                    "reaches y = {:g} m above it: give a table over elevation",
                    key.name, reading_.place->y));
  if (!key.range.contains(*value))
    return refuse(key, node,
                  fmt::format("'{}' = {:.6g} at y = {:g} m is out of range, must be {}", key.name, *value,
                              reading_.place->y, with_unit(key.range.text(), key.unit)));
  return value;
}

std::optional<std::string> TableReader::convert_text(const Key& key, const toml::node& node) {
  if (!node.is_string())
    return refuse(key, node, fmt::format("'{}' must be a string, found {}", key.name, type_name(node)));
  const std::string value = *node.value<std::string>();
  if (value.empty())
    return refuse(key, node, fmt::format("'{}' is empty", key.name));
  if (!is_printable_line(value))
    return refuse(
        key, node,
        fmt::format("'{}' = \"{}\" holds a control character or the end of a line, must be plain text",
                    key.name, value));
  if (!key.choices.empty() && std::ranges::find(key.choices, value) == key.choices.end())
    return refuse(
        key, node,
        fmt::format("'{}' = \"{}\" is not known, {}", key.name, value, suggestion(value, key.choices)));
  return value;
}

/// If choices are given by name, all other names keep the default.
std::optional<std::string> TableReader::convert_choice_by_name(const Key& key, const toml::node& node) {
  const toml::table* const table = node.as_table();
  if (table == nullptr && node.is_string())
    return convert_text(key, node);
  if (table == nullptr || table->empty())
    return refuse(key, node,
                  fmt::format("'{}' must be a {}, found {}", key.name, type_text(key),
                              table == nullptr ? type_name(node) : "an empty table"));
  for (const auto& [name, element] : *table) {
    const auto begin = name.source().begin;
    reading_.findings.locate(fmt::format("{}.{}", path(key.name), name.str()),
                             {begin.line, begin.column, shown_});
    const auto word = convert_text(key, element);
    if (!word)
      return std::nullopt;
    by_name_[key.name].emplace(name.str(), *word);
  }
  return std::string(key.fallback);
}

/// Kept as the word that stands in the file.
std::optional<std::string> TableReader::convert_boolean(const Key& key, const toml::node& node) {
  if (!node.is_boolean())
    return refuse(key, node, fmt::format("'{}' must be true or false, found {}", key.name, type_name(node)));
  return *node.value<bool>() ? "true" : "false";
}

std::optional<TableReader::Value> TableReader::convert_numbers(const Key& key, const toml::node& node) {
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() != key.count)
    return refuse(key, node,
                  fmt::format("'{}' must be an {}, found {}", key.name, type_text(key),
                              array == nullptr ? type_name(node) : fmt::format("{} entries", array->size())));
  return convert_elements(key, *array);
}

std::optional<TableReader::Value> TableReader::convert_series(const Key& key, const toml::node& node) {
  if (const toml::array* array = node.as_array()) {
    if (array->empty())
      return refuse(key, node, fmt::format("'{}' is empty", key.name));
    return convert_elements(key, *array);
  }
  const auto value = convert_number(key, node);
  return value ? std::optional<Value>(std::vector<double>{*value}) : std::nullopt;
}

std::optional<TableReader::Value> TableReader::convert_elements(const Key& key, const toml::array& array) {
  std::vector<double> values;
  for (const toml::node& element : array) {
    const auto value = convert_number(key, element);
    if (!value)
      return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::optional<TableReader::Value> TableReader::convert_points(const Key& key, const toml::node& node,
                                                              std::size_t least) {
  const toml::array* corners = node.as_array();
  if (corners == nullptr || corners->size() < least)
    return refuse(
        key, node,
        fmt::format("'{}' must be an {}, found {}", key.name, type_text(key),
                    corners == nullptr ? type_name(node) : fmt::format("{} entries", corners->size())));
  Polygon polygon;
  for (const toml::node& corner : *corners) {
    const toml::array* pair = corner.as_array();
    if (pair == nullptr || pair->size() != 2)
      return refuse(key, corner,
                    fmt::format("corner {} of '{}' must be a point [x, y]", polygon.size() + 1, key.name));
    const auto x = convert_number(key, *pair->get(0));
    const auto y = x ? convert_number(key, *pair->get(1)) : std::nullopt;
    if (!y)
      return std::nullopt;
    polygon.push_back({*x, *y});
  }
  return polygon;
}

std::optional<TableReader::Value> TableReader::convert_texts(const Key& key, const toml::node& node) {
  const toml::array* array = node.as_array();
  if (array == nullptr)
    return refuse(key, node,
                  fmt::format("'{}' must be an {}, found {}", key.name, type_text(key), type_name(node)));
  if (array->empty())
    return refuse(key, node, fmt::format("'{}' is empty", key.name));
  std::vector<std::string> values;
  for (const toml::node& element : *array) {
    auto value = convert_text(key, element);
    if (!value)
      return std::nullopt;
    if (std::ranges::find(values, *value) != values.end())
      return refuse(key, element, fmt::format("'{}' stands twice in '{}'", *value, key.name));
    values.push_back(std::move(*value));
  }
  return values;
}

std::optional<TableReader::Value> TableReader::convert_choices(const Key& key, const toml::node& node) {
  const toml::array* array = node.as_array();
  if (array == nullptr)
    return refuse(key, node,
                  fmt::format("'{}' must be an {}, found {}", key.name, type_text(key), type_name(node)));
  std::vector<std::string> values;
  for (const toml::node& element : *array) {
    const auto value = element.value<std::string>();
    if (!value)
      return refuse(key, element,
                    fmt::format("'{}' must hold strings, found {}", key.name, type_name(element)));
    if (std::ranges::find(key.choices, *value) == key.choices.end())
      return refuse(
          key, element,
          fmt::format("'{}' in '{}' is not known, {}", *value, key.name, suggestion(*value, key.choices)));
    if (std::ranges::find(values, *value) != values.end())
      return refuse(key, element, fmt::format("'{}' stands twice in '{}'", *value, key.name));
    values.push_back(*value);
  }
  return values;
}

template <class T>
T TableReader::get(std::string_view key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? T{} : std::get<T>(found->second);
}

void TableReader::settle(std::string_view key, double value, std::string_view origin) {
  const Key* known = spec_.find(key);
  values_.insert_or_assign(known->name, value);
  settled_.insert(known->name);
  std::erase_if(reading_.values, [&](const ValueInForce& one) { return one.key == path(key); });
  reading_.values.push_back({path(key), fmt::format("{}", value), std::string(origin)});
}

std::optional<double> TableReader::optional_number(std::string_view key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? std::nullopt : std::optional(std::get<double>(found->second));
}

std::string TableReader::text(std::string_view key) const {
  return get<std::string>(key);
}
std::map<std::string, std::string> TableReader::words_by_name(std::string_view key) const {
  const auto found = by_name_.find(key);
  return found == by_name_.end() ? std::map<std::string, std::string>{} : found->second;
}
std::vector<double> TableReader::numbers(std::string_view key) const {
  return get<std::vector<double>>(key);
}
Polygon TableReader::polygon(std::string_view key) const {
  return get<Polygon>(key);
}
std::vector<std::string> TableReader::texts(std::string_view key) const {
  return get<std::vector<std::string>>(key);
}

Point TableReader::point(std::string_view key) const {
  const auto pair = numbers(key);
  return pair.empty() ? Point{} : Point{pair[0], pair[1]};
}

} // namespace tremolo::scene
