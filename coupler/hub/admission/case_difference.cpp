#include "coupler/hub/admission/case_difference.hpp"

#include <fmt/format.h>
#include <sstream>

namespace tremolo::coupler {

std::string case_difference(std::string_view theirs, std::string_view ours) {
  if (theirs == ours)
    return {};
  std::istringstream their_lines{std::string(theirs)};
  std::istringstream our_lines{std::string(ours)};
  std::string table;
  std::string their_line;
  std::string our_line;
  int number = 0;
  do {
    ++number;
    if (our_line.starts_with('['))
      table = fmt::format(", {}", our_line);
    const auto next = [](std::istringstream& lines, std::string& line) {
      return static_cast<bool>(std::getline(lines, line)) || (line = "(end of the file)", false);
    };
    const bool more = next(their_lines, their_line);
    if (!next(our_lines, our_line) && !more)
      return "only the ends of the last lines differ";
  } while (their_line == our_line);
  return fmt::format("line {}{}: '{}' against '{}'", number, table, their_line, our_line);
}

} // namespace tremolo::coupler
