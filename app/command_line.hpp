#pragma once

// The command line as the commands see it: the parts of CLI11 that they use, under CLI11's own names. A file
// that includes CLI11 and reads four options takes 14 s of CPU to compile with -O3, with this header 0.8 s;
// 25 commands would add five minutes to a build. So command_line.cpp alone includes it.

#include "app/manual/command_table.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace tremolo::app {

/// An option or an argument of a command. What a command line gives it is checked before the command runs.
class Option {
public:
  explicit Option(CLI::Option& option) : option_(option) {}

  Option* required();
  Option* one_of(std::vector<std::string> values);
  Option* existing_file();
  Option* existing_folder();
  Option* positive();
  Option* non_negative();
  Option* between(int least, int most);
  Option* between(double least, double most);
  /// Only together with the other one.
  Option* needs(const Option* other);
  /// Never together with the other one.
  Option* excludes(const Option* other);
  Option* excludes(const std::string& other);
  /// Number of values that follow the option.
  Option* expected(int count);
  Option* expected(int least, int most);
  /// One value each time that the option is given, though it holds several.
  Option* one_at_a_time();
  Option* delimiter(char between);
  /// The help shows the value that the variable has now.
  Option* capture_default_str();
  /// The value of the option where none follows it.
  Option* default_str(const std::string& value);
  OptionRow row() const;

private:
  CLI::Option& option_;
  std::vector<std::string> choices_;
};

/// The program or one of its commands.
class Command {
public:
  explicit Command(CLI::App& app);
  ~Command();
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  /// Commands that are added from here on stand under this heading in the help.
  void begin_group(const std::string& heading) { group_ = heading; }
  Command* add_subcommand(const std::string& name, const std::string& description);
  /// A command that leaves all that follows its name, --help too, to the action.
  void add_relay(const std::string& name, const std::string& description,
                 const std::function<void(const std::vector<std::string>&)>& action);
  /// The variable outlives the command. Numbers, texts and paths, optional ones and lists of them: the types
  /// for which command_line.cpp makes this function.
  template <class Value>
  Option* add_option(const std::string& name, Value& variable, const std::string& description);
  Option* add_flag(const std::string& name, bool& variable, const std::string& description);
  void footer(const std::string& text);
  /// Called with all variables set.
  void callback(const std::function<void()>& action);
  /// The program with its commands; those that a relay serves lack their options.
  CommandTable table() const;

private:
  CommandRow row() const;

  CLI::App& app_;
  bool relay_ = false;
  std::string group_ = "Commands";
  std::vector<std::unique_ptr<Option>> options_;
  std::vector<std::unique_ptr<Command>> commands_;
};

/// Reports, from a callback, that the command line lacks these options.
[[noreturn]] void throw_required(const std::string& names);

/// Calls the command that the command line names.
/// @param greeting      printed where the command line is empty
/// @param add_commands  adds them to the program
/// @return the exit status; `refused` after saying why
int run_command_line(int argc, char** argv, const std::string& program, const std::string& description,
                     const std::string& version, const std::string& greeting,
                     const std::function<void(Command&)>& add_commands);

} // namespace tremolo::app
