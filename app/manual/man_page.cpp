// Pages for man(1) in the macros of man(7).

#include "app/manual/man_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace tremolo::app {
namespace {

/// Text as roff takes it: no escapes, no requests, and hyphens that can be copied.
std::string plain(std::string_view text) {
  std::string result;
  bool line_starts = true;
  for (const char c : text) {
    if (line_starts && (c == '.' || c == '\''))
      result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
    line_starts = c == '\n';
  }
  return result;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string heading(const std::string& page, const std::string& summary, const std::string& version) {
  return fmt::format(".TH {} 1 \"\" \"{}\" \"tremolo manual\"\n.SH NAME\n{} \\- {}\n", plain(upper(page)),
                     plain(version), plain(page), plain(summary));
}

/// "-o, --out FILE" with names in bold and what follows in italics.
std::string named(const OptionRow& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names)
    names.push_back(fmt::format("\\fB{}\\fR", plain(name)));
  const std::string value =
      option.has_place || option.value.empty() ? "" : fmt::format(" \\fI{}\\fR", plain(option.value));
  return fmt::format("{}{}", fmt::join(names, ", "), value);
}

std::string list(const CommandRow& command, bool with_place) {
  std::string text;
  for (const OptionRow& option : command.options)
    if (option.has_place == with_place)
      text += fmt::format(".TP\n{}\n{}{}\n", named(option), plain(option.description),
                          option.required && !with_place ? " (required)" : "");
  return text;
}

std::string synopsis(const CommandTable& table, const CommandRow& command) {
  std::string text =
      fmt::format(".SH SYNOPSIS\n\\fB{} {}\\fR [\\fIoptions\\fR]", table.program, plain(command.name));
  for (const OptionRow& option : command.options)
    if (option.has_place) {
      const std::string name = fmt::format("\\fI{}\\fR", plain(option.names.front()));
      text += " " + (option.required ? name : "[" + name + "]");
    }
  return text + "\n";
}

std::string section(const std::string& title, const std::string& text) {
  return text.empty() ? "" : fmt::format(".SH {}\n{}", title, text);
}

} // namespace

std::string man_page(const CommandTable& table, const std::string& version) {
  // The description begins with the program's name, which the macro sets anyway.
  const std::size_t colon = table.description.find(": ");
  std::string text =
      heading(table.program,
              colon == std::string::npos ? table.description : table.description.substr(colon + 2), version) +
      fmt::format(".SH SYNOPSIS\n\\fB{}\\fR \\fICOMMAND\\fR [\\fIarguments\\fR]\n.SH COMMANDS\n",
                  table.program);
  for (const CommandRow& command : table.commands)
    text += fmt::format(".TP\n\\fB{0}\\fR\n{1}; see \\fB{2}\\-{0}\\fR(1)\n", plain(command.name),
                        plain(command.description), table.program);
  return text + section("EXIT STATUS",
                        "0: done. 1: failed, with the reason on standard error. 2: the case file or "
                        "the command line is refused.\n");
}

std::string man_page(const CommandTable& table, const CommandRow& command, const std::string& version) {
  return heading(table.program + "-" + command.name, command.description, version) +
         synopsis(table, command) + section("ARGUMENTS", list(command, true)) +
         section("OPTIONS", list(command, false)) +
         section("NOTES", command.footer.empty() ? "" : ".nf\n" + plain(command.footer) + "\n.fi\n") +
         fmt::format(".SH SEE ALSO\n\\fB{}\\fR(1)\n", table.program);
}

} // namespace tremolo::app
