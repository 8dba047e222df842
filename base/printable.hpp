#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tremolo {

/// What another process says, as it may be shown on a terminal: control characters but for the end of a line
/// and the tabulator, and bytes that are no UTF-8, become \xNN; what is longer than most bytes is cut, and
/// says so.
std::string printable(std::string_view text, std::size_t most = 4096);

/// printable() in one line: the ends of lines become \n.
std::string printable_line(std::string_view text);

/// Whether a text may be shown in one line as it is.
bool is_printable_line(std::string_view text);

} // namespace tremolo
