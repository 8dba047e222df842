#pragma once

// Edits of a case's text that leave everything else, comments included, as it stands.

#include <toml++/toml.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace tremolo::scene {

/// Bytes of a text, and what stands there instead.
struct Replacement {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string value;
};

/// Byte offset of a position; columns count characters of UTF-8.
std::size_t offset(std::string_view text, toml::source_position position);

/// Takes out a pair of key and value with what parted it from its neighbours: the comma before it, or after
/// it where it opens an inline table; outside of one the line, unless a comment ends it.
Replacement without_pair(std::string_view text, std::size_t key, std::size_t value_end);

/// Separator between the value of the pair at `key` and the name of another key of its table: a comma in an
/// inline table, otherwise a new line, with the prefix of a dotted key.
std::string separator_after(std::string_view text, std::size_t key);

} // namespace tremolo::scene
