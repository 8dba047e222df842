#pragma once

// Reading of TOML tables against the key table: every key of a table is checked for name, type, finite value,
// range and applicability when the table is opened; the getters then hand out values.

#include "scene/case.hpp"
#include "scene/keys/keys.hpp"
#include "scene/read/soil/depth_profile.hpp"
#include "scene/text/findings.hpp"

#include <toml++/toml.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tremolo::scene {

/// "a string", "an array", ...
std::string type_name(const toml::node& node);

/// State shared by the readers of all tables of a file.
struct Reading {
  KeyTable keys;
  Findings& findings;
  std::vector<ValueInForce>& values;
  DepthProfiles* profiles = nullptr; ///< where keys may vary over depth: which do
  const SlicePlace* place = nullptr; ///< where these are evaluated; they have a typical value without it
};

/// The soil of the library that a table names; its keys hold where the table has none.
struct LibraryKeys {
  std::string_view name;
  const toml::table* table = nullptr;
};

/// One table of the file, checked. A key that is missing or wrong has been reported; its getter then gives
/// nothing, zero, or an empty value.
class TableReader {
public:
  /// `node` is nullptr where the file does not have the table; defaults then hold.
  /// @param path   for messages and rules, "region[0]"
  /// @param shown  the table's name in messages, "[region]"
  TableReader(const Table& spec, const toml::table* node, std::string path, std::string shown,
              Reading reading);

  const std::string& path() const { return path_; }
  std::string path(std::string_view key) const;

  /// Whether the key stands in the file (right or wrong), or in the library's soil that it names, or was
  /// settled.
  bool given(std::string_view key) const;

  /// Whether a key has a profile over depth in place of a number.
  bool varies_over_depth() const;

  /// Puts a number that follows from others in place of one that is not in the file, or of one that means it.
  void settle(std::string_view key, double value, std::string_view origin);

  std::optional<double> optional_number(std::string_view key) const;
  double number(std::string_view key) const { return optional_number(key).value_or(0.0); }
  int integer(std::string_view key) const { return static_cast<int>(number(key)); }
  /// A text or a choice.
  std::string text(std::string_view key) const;
  bool boolean(std::string_view key) const { return text(key) == "true"; }
  /// The value of a choice by its word; the first one where it is missing.
  template <Worded Enum>
  Enum choice(std::string_view key) const {
    return value_named<Enum>(text(key)).value_or(words(Enum{}).front().value);
  }
  /// The choices that a key of Type::choice_by_name gives by name; empty if it has one choice for all.
  std::map<std::string, std::string> words_by_name(std::string_view key) const;
  /// The value of a key of Type::numbers or Type::series.
  std::vector<double> numbers(std::string_view key) const;
  Point point(std::string_view key) const;
  /// The corners of a key of Type::polygon, Type::line or Type::points.
  Polygon polygon(std::string_view key) const;
  /// The texts of a key of Type::texts or Type::choices.
  std::vector<std::string> texts(std::string_view key) const;

  /// The table below this one, where the file has it: `circle` of [[structure]] by the spec
  /// "structure.circle".
  std::optional<TableReader> table(std::string_view key) const;
  /// The tables of an array of tables.
  std::vector<TableReader> tables(std::string_view key) const;

private:
  using Value = std::variant<double, std::string, std::vector<double>, Polygon, std::vector<std::string>>;

  void find_library();
  void refuse_unknown_keys();
  const toml::node* node_of(std::string_view key) const;
  bool from_library(std::string_view key) const;
  std::string origin(std::string_view key, const toml::node& node) const;
  std::string shown_value(const Key& key, const Value& value) const;
  void report_missing(const Key& key);
  bool applies(const Key& key) const;
  void read(const Key& key);
  void put_default(const Key& key);
  std::optional<Value> convert(const Key& key, const toml::node& node);
  std::optional<double> convert_number(const Key& key, const toml::node& node);
  std::optional<double> convert_profile(const Key& key, const toml::table& node);
  std::optional<std::string> convert_text(const Key& key, const toml::node& node);
  std::optional<std::string> convert_choice_by_name(const Key& key, const toml::node& node);
  std::optional<std::string> convert_boolean(const Key& key, const toml::node& node);
  std::optional<Value> convert_numbers(const Key& key, const toml::node& node);
  std::optional<Value> convert_elements(const Key& key, const toml::array& array);
  std::optional<Value> convert_series(const Key& key, const toml::node& node);
  std::optional<Value> convert_points(const Key& key, const toml::node& node, std::size_t least);
  std::optional<Value> convert_texts(const Key& key, const toml::node& node);
  std::optional<Value> convert_choices(const Key& key, const toml::node& node);
  std::nullopt_t refuse(const Key& key, const toml::node& node, std::string text);
  template <class T>
  T get(std::string_view key) const;

  const Table& spec_;
  const toml::table* node_;
  std::string path_;
  std::string shown_;
  Reading reading_;
  LibraryKeys library_;
  std::map<std::string_view, Value> values_;
  std::map<std::string_view, std::map<std::string, std::string>> by_name_; ///< of choices
  std::set<std::string_view> settled_;
};

/// A named table, [soil.NAME].
struct NamedTable {
  std::string name;
  TableReader reader;
};

/// The whole file.
class Document {
public:
  Document(const toml::table& root, Reading reading) : root_(root), reading_(reading) {}

  /// A single table, "boundary.left"; "" is the top of the file. A missing one is reported if it is required.
  TableReader table(std::string_view name);
  /// Whether the file has a table (or anything else) of this name.
  bool has(std::string_view name) const { return root_.at_path(name).node() != nullptr; }
  std::vector<TableReader> array(std::string_view name);
  std::vector<NamedTable> named(std::string_view name);

private:
  const toml::table& root_;
  Reading reading_;
};

} // namespace tremolo::scene
