#include "app/manual/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

namespace tremolo::app {
namespace {

/// Text between single quotes, for any of the shells.
std::string single_quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// All names of a command's options.
std::vector<std::string> option_names(const CommandRow& command) {
  std::vector<std::string> names{"--help"};
  for (const OptionRow& option : command.options)
    if (!option.has_place)
      for (const std::string& name : option.names)
        if (name != "--help")
          names.push_back(name);
  return names;
}

std::vector<std::string> command_names(const CommandTable& table) {
  std::vector<std::string> names;
  for (const CommandRow& command : table.commands)
    names.push_back(command.name);
  return names;
}

/// A description as zsh's _describe and _arguments take it.
std::string zsh_escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == ':' || c == '[' || c == ']' || c == '\\')
      result += '\\';
    result += c;
  }
  return result;
}

std::string zsh_argument(const OptionRow& option, const std::string& name) {
  std::string argument = fmt::format("{}[{}]", name, zsh_escaped(option.description));
  if (!option.choices.empty())
    argument += fmt::format(":value:({})", fmt::join(option.choices, " "));
  else if (!option.value.empty())
    argument += ":value:_files";
  return single_quoted(argument);
}

} // namespace

std::string bash_completion(const CommandTable& table) {
  std::string text = fmt::format(R"(_{0}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} options= values=
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W '--help --version {1}' -- "$word"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
)",
                                 table.program, fmt::join(command_names(table), " "));
  for (const CommandRow& command : table.commands) {
    text += fmt::format("    {})\n      options={}\n", command.name,
                        single_quoted(fmt::format("{}", fmt::join(option_names(command), " "))));
    std::string choices;
    for (const OptionRow& option : command.options)
      if (!option.has_place && !option.choices.empty())
        choices += fmt::format("        {}) values={} ;;\n", fmt::join(option.names, "|"),
                               single_quoted(fmt::format("{}", fmt::join(option.choices, " "))));
    if (!choices.empty())
      text += fmt::format("      case $previous in\n{}      esac\n", choices);
    text += "      ;;\n";
  }
  return text + fmt::format(R"(  esac
  if [ -n "$values" ]; then
    COMPREPLY=($(compgen -W "$values" -- "$word"))
  elif [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}}
complete -o filenames -F _{0} {0}
)",
                            table.program);
}

std::string zsh_completion(const CommandTable& table) {
  std::string text = fmt::format("#compdef {0}\n_{0}() {{\n  local -a commands=(\n", table.program);
  for (const CommandRow& command : table.commands)
    text += fmt::format("    {}\n", single_quoted(command.name + ":" + zsh_escaped(command.description)));
  text += "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
          "  local name=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $name in\n";
  for (const CommandRow& command : table.commands) {
    text += fmt::format("    {})\n      _arguments '--help[Print the help message]'", command.name);
    for (const OptionRow& option : command.options)
      if (!option.has_place)
        for (const std::string& name : option.names)
          text += " \\\n        " + zsh_argument(option, name);
    text += " \\\n        '*:file:_files'\n      ;;\n";
  }
  return text + fmt::format("  esac\n}}\n_{0} \"$@\"\n", table.program);
}

std::string fish_completion(const CommandTable& table) {
  const std::string& program = table.program;
  std::string text = fmt::format("# Commands come first; what follows may be a file.\n"
                                 "complete -c {0} -n __fish_use_subcommand -f\n",
                                 program);
  for (const CommandRow& command : table.commands)
    text += fmt::format("complete -c {} -n __fish_use_subcommand -a {} -d {}\n", program, command.name,
                        single_quoted(command.description));
  for (const CommandRow& command : table.commands)
    for (const OptionRow& option : command.options) {
      if (option.has_place)
        continue;
      text += fmt::format("complete -c {} -n '__fish_seen_subcommand_from {}'", program, command.name);
      for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option.choices.empty())
        text += fmt::format(" -x -a {}", single_quoted(fmt::format("{}", fmt::join(option.choices, " "))));
      else if (!option.value.empty())
        text += " -r";
      text += fmt::format(" -d {}\n", single_quoted(option.description));
    }
  return text;
}

} // namespace tremolo::app
