#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tremolo {

/// A text of another process, made safe for a terminal: control characters except line feed and tab, and
/// bytes that are not UTF-8, become \xNN; a text longer than `most` bytes is cut, with a remark.
std::string printable(std::string_view text, std::size_t most = 4096);

/// printable() in one line: the ends of lines become \n.
std::string printable_line(std::string_view text);

/// Whether a text may be shown unchanged in one line.
bool is_printable_line(std::string_view text);

} // namespace tremolo
