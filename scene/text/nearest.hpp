#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tremolo::scene {

/// Number of single-character insertions, deletions, replacements and swaps of neighbours that make b of a.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// "did you mean 'x'?" for the nearest of the known words if it is near enough to be a slip, otherwise
/// "known: a, b, c".
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

} // namespace tremolo::scene
