#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tremolo::scene {

/// A value as a case file writes it: what is valid TOML as it stands, anything else as a string.
std::string toml_value(std::string_view text);

/// The text of a case with one more value, and everything else, comments included, as it stands. The result
/// is not checked: parse() it, which also refuses a key that no case has and names the nearest one.
/// @param key    dotted, e.g. "mesh.size", "soil.sand.young" or "region[0].polygon"; one that the text does
/// not
///               have yet is added to its table, and the table to the text
/// @param value  as TOML; none: without this key
/// @throws std::invalid_argument for a key that is not a path of keys, or that has no place in the text
std::string with_value(std::string_view text, const std::string& key,
                       const std::optional<std::string>& value);

} // namespace tremolo::scene
