#pragma once

// Every key of the files that users write, in one table for each kind of file. Reading, range checks and the
// generated reference (docs/case-file.md, docs/case.schema.json, docs/soil-test-file.md, ...) all come from
// here, so a reference that differs from the program cannot exist.

#include "base/range.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene {

enum class Type {
  text,
  number,
  integer,
  choice,         ///< one of Key::choices
  choice_by_name, ///< the same, or a table that has one for each of some names; for others the default holds
  texts,          ///< an array of at least one text, each at most once
  choices,        ///< an array of them, each at most once
  boolean,        ///< true or false
  numbers,        ///< an array of Key::count numbers
  numbers_or_false, ///< the same, or false, which has none
  series,           ///< a number, or an array of at least one
  polygon,          ///< an array of at least three points [x, y]
  line,             ///< an array of at least two of them
  points,           ///< an array of at least one
};

/// Keys that exist only for some values of another key of the same table.
struct Condition {
  std::string_view key;
  std::vector<std::string_view> values;
};

struct Key {
  std::string_view name;
  Type type = Type::number;
  std::string_view unit = {};
  std::string_view meaning;
  bool required = false;
  std::string_view fallback = {};  ///< default, as it would stand in the file without quotes
  std::string_view otherwise = {}; ///< in words, what holds without the key and without a fixed default
  Range range = {};
  std::vector<std::string_view> choices = {};
  std::size_t count = 0;      ///< of Type::numbers and numbers_or_false
  std::string_view form = {}; ///< of Type::numbers and numbers_or_false, "[x, y]"
  Condition when = {};
  bool over_depth = false; ///< of Type::number: a case may give a profile over depth instead
};

enum class Kind {
  single, ///< [name]
  named,  ///< [name.NAME], any number
  array,  ///< [[name]], any number
};

struct Table {
  std::string_view name; ///< dotted, "boundary.left"; empty: the top of the file
  Kind kind = Kind::single;
  bool required = false;
  bool open = false; ///< takes keys that are not listed
  std::string_view meaning;
  std::vector<Key> keys;

  /// nullptr if there is none of this name
  const Key* find(std::string_view key) const;
};

/// All tables of a kind of file in the order of the reference; a table stands behind its parent.
using KeyTable = std::span<const Table>;

/// The keys of case files.
KeyTable case_keys();
/// The keys of soil tests and calibrations.
KeyTable soil_test_keys();
/// The keys of studies, `tremolo sweep STUDY`; [axes] takes keys of the case.
KeyTable study_keys();
/// The keys of the soils in materials/library.
KeyTable library_keys();

/// @throws std::logic_error for a name that is not in the table
const Table& table_spec(KeyTable keys, std::string_view name);

/// Names of the tables directly below `parent` ("" for the top of the file), without the parent's prefix.
std::vector<std::string_view> subtables(KeyTable keys, std::string_view parent);

/// "number", "array of 2 numbers [x, y]", ...
std::string type_text(const Key& key);

} // namespace tremolo::scene
