#include "app/manual/command_page.hpp"

#include "base/text/paragraph.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

namespace tremolo::app {
namespace {

/// Text in a table's cell: a bar there would end it.
std::string cell(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|')
      result += '\\';
    result += c;
  }
  return result;
}

std::string usage(const CommandTable& table, const CommandRow& command) {
  std::string text = table.program + " " + command.name;
  for (const OptionRow& option : command.options)
    if (option.has_place)
      text += " " + (option.required ? option.names.front() : "[" + option.names.front() + "]");
  return text + " [options]";
}

std::string row(const OptionRow& option) {
  const std::string value = option.has_place || option.value.empty() ? "" : " " + option.value;
  return fmt::format("| `{}{}` | {}{} |\n", fmt::join(option.names, ", "), value, cell(option.description),
                     option.required ? " (required)" : "");
}

} // namespace

std::string command_page(const CommandTable& table) {
  std::string text =
      fmt::format("# Commands\n\nWhat can be typed after `{0}`, with every argument and option. `{0} COMMAND "
                  "--help` prints the part of a\ncommand; `man {0}-COMMAND` shows it where {0} is installed. "
                  "`{0} docs` writes this page.\n",
                  table.program);
  for (const CommandRow& command : table.commands) {
    text += fmt::format("\n## {}\n\n{}\n\n    {}\n", command.name, wrapped(command.description + "."),
                        usage(table, command));
    if (!command.options.empty()) {
      text += "\n| argument or option | meaning |\n| --- | --- |\n";
      for (const OptionRow& option : command.options)
        text += row(option);
    }
    if (!command.footer.empty())
      text += fmt::format("\n{}\n", wrapped(command.footer));
  }
  return text;
}

} // namespace tremolo::app
