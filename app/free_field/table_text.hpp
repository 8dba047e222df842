#pragma once

// Words and numbers of a line of a text table.

#include <optional>
#include <string_view>
#include <vector>

namespace tremolo::app {

/// Without blanks at either end.
std::string_view trimmed(std::string_view text);

/// The cells between separators, trimmed.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The words between blanks.
std::vector<std::string_view> words(std::string_view text);

/// The number in a text; empty unless it is a finite number.
std::optional<double> finite_number(std::string_view text);

} // namespace tremolo::app
