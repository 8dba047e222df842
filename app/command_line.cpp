#include "app/command_line.hpp"

#include "app/commands.hpp"
#include "scene/text/nearest.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace tremolo::app {

namespace {

/// A check of a number by its range. CLI11's own checks let a NaN pass, and print bounds with all their
/// digits.
/// @param range  "> 0", as help and messages name it
CLI::Validator number_in(const std::string& range, const std::function<bool(double)>& holds) {
  const auto check = [range, holds](const std::string& word) {
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (end == word.c_str() || *end != '\0')
      return fmt::format("'{}' is no number; it must be {}", word, range);
    return holds(value) ? std::string() : fmt::format("{} must be {}", word, range);
  };
  return {check, "number " + range};
}

template <class Value>
CLI::Validator number_between(Value least, Value most) {
  return number_in(fmt::format("in [{:g}, {:g}]", static_cast<double>(least), static_cast<double>(most)),
                   [least, most](double value) { return least <= value && value <= most; });
}

/// A check of a path that must exist as a folder, or as anything but a folder.
CLI::Validator path_to(bool folder) {
  const auto check = [folder](const std::string& path) {
    std::error_code trouble;
    if (!std::filesystem::exists(path, trouble))
      return fmt::format("there is no {} {}", folder ? "folder" : "file", path);
    if (std::filesystem::is_directory(path, trouble) != folder)
      return fmt::format("{} is a {}; give a {}", path, folder ? "file" : "folder",
                         folder ? "folder" : "file");
    return std::string();
  };
  return {check, folder ? "DIR" : "FILE"};
}

} // namespace

Option* Option::required() {
  option_.required();
  return this;
}

Option* Option::one_of(std::vector<std::string> values) {
  option_.check(CLI::IsMember(values));
  choices_ = std::move(values);
  return this;
}

Option* Option::existing_file() {
  option_.check(path_to(false));
  return this;
}

Option* Option::existing_folder() {
  option_.check(path_to(true));
  return this;
}

Option* Option::positive() {
  option_.check(number_in("> 0", [](double value) { return value > 0.0; }));
  return this;
}

Option* Option::non_negative() {
  option_.check(number_in(">= 0", [](double value) { return value >= 0.0; }));
  return this;
}

Option* Option::between(int least, int most) {
  option_.check(number_between(least, most));
  return this;
}

Option* Option::between(double least, double most) {
  option_.check(number_between(least, most));
  return this;
}

Option* Option::needs(const Option* other) {
  option_.needs(&other->option_);
  return this;
}

Option* Option::excludes(const Option* other) {
  option_.excludes(&other->option_);
  return this;
}

Option* Option::excludes(const std::string& other) {
  option_.excludes(other);
  return this;
}

Option* Option::expected(int count) {
  option_.expected(count);
  return this;
}

Option* Option::expected(int least, int most) {
  option_.expected(least, most);
  return this;
}

Option* Option::one_at_a_time() {
  option_.allow_extra_args(false);
  return this;
}

Option* Option::delimiter(char between) {
  option_.delimiter(between);
  return this;
}

Option* Option::capture_default_str() {
  option_.capture_default_str();
  return this;
}

Option* Option::default_str(const std::string& value) {
  option_.default_str(value);
  return this;
}

OptionRow Option::row() const {
  OptionRow row{.description = option_.get_description(),
                .choices = choices_,
                .has_place = option_.get_positional(),
                .required = option_.get_required()};
  if (row.has_place)
    row.names.push_back(option_.get_single_name());
  for (const std::string& name : option_.get_snames())
    row.names.push_back("-" + name);
  for (const std::string& name : option_.get_lnames())
    row.names.push_back("--" + name);
  if (option_.get_items_expected_max() > 0) {
    // "TEXT:FILE", "INT:INT in [1 - 1024]": the part after the colon says more.
    const std::string type = option_.get_type_name();
    const std::size_t colon = type.find(':');
    row.value = colon == std::string::npos ? type : type.substr(colon + 1);
  }
  return row;
}

Command::Command(CLI::App& app) : app_(app) {}
Command::~Command() = default;

Command* Command::add_subcommand(const std::string& name, const std::string& description) {
  CLI::App& command = *app_.add_subcommand(name, description)->group(group_);
  return commands_.emplace_back(std::make_unique<Command>(command)).get();
}

void Command::add_relay(const std::string& name, const std::string& description,
                        const std::function<void(const std::vector<std::string>&)>& action) {
  auto* command = app_.add_subcommand(name, description)->group(group_);
  commands_.emplace_back(std::make_unique<Command>(*command))->relay_ = true;
  command->prefix_command();
  command->set_help_flag();
  command->callback([command, action] { action(command->remaining()); });
}

namespace {

/// Refuses NaN and infinity where an option has no range of its own.
std::string finite(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  return *end == '\0' && !std::isfinite(value) ? fmt::format("{} is no finite number", word) : "";
}

template <class Value>
constexpr bool is_real = std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>> ||
                         std::is_same_v<Value, std::vector<double>>;

} // namespace

template <class Value>
Option* Command::add_option(const std::string& name, Value& variable, const std::string& description) {
  CLI::Option& option = *app_.add_option(name, variable, description);
  if constexpr (is_real<Value>)
    option.check(finite);
  return options_.emplace_back(std::make_unique<Option>(option)).get();
}

template Option* Command::add_option(const std::string&, int&, const std::string&);
template Option* Command::add_option(const std::string&, double&, const std::string&);
template Option* Command::add_option(const std::string&, std::string&, const std::string&);
template Option* Command::add_option(const std::string&, std::filesystem::path&, const std::string&);
template Option* Command::add_option(const std::string&, std::optional<int>&, const std::string&);
template Option* Command::add_option(const std::string&, std::optional<double>&, const std::string&);
template Option* Command::add_option(const std::string&, std::optional<std::string>&, const std::string&);
template Option* Command::add_option(const std::string&, std::optional<std::filesystem::path>&,
                                     const std::string&);
template Option* Command::add_option(const std::string&, std::vector<double>&, const std::string&);
template Option* Command::add_option(const std::string&, std::vector<std::string>&, const std::string&);
template Option* Command::add_option(const std::string&, std::vector<std::filesystem::path>&,
                                     const std::string&);

Option* Command::add_flag(const std::string& name, bool& variable, const std::string& description) {
  return options_.emplace_back(std::make_unique<Option>(*app_.add_flag(name, variable, description))).get();
}

void Command::footer(const std::string& text) {
  app_.footer(text);
}

void Command::callback(const std::function<void()>& action) {
  app_.callback(action);
}

CommandRow Command::row() const {
  CommandRow row{.name = app_.get_name(),
                 .description = app_.get_description(),
                 .footer = app_.get_footer(),
                 .options = {},
                 .relay = relay_};
  for (const auto& option : options_)
    row.options.push_back(option->row());
  return row;
}

CommandTable Command::table() const {
  CommandTable table{.program = app_.get_name(), .description = app_.get_description(), .commands = {}};
  for (const auto& command : commands_)
    table.commands.push_back(command->row());
  return table;
}

void throw_required(const std::string& names) {
  throw CLI::RequiredError(names);
}

namespace {

/// Says which command was meant. @throws Exit
void require_known(const CLI::App& app, std::string_view word) {
  if (word.starts_with('-'))
    return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({}))
    names.push_back(command->get_name());
  if (std::ranges::find(names, word) != names.end())
    return;
  std::fprintf(stderr, "tremolo: '%.*s' is no command, %s\n", static_cast<int>(word.size()), word.data(),
               scene::suggestion(word, std::vector<std::string_view>(names.begin(), names.end())).c_str());
  throw Exit{refused};
}

/// A line for each option that the command does not have and others do.
std::string where_options_belong(const CLI::App& app, const std::vector<std::string>& words) {
  const auto commands = app.get_subcommands({});
  const auto meant = std::ranges::find(commands, words.front(), &CLI::App::get_name);
  std::string lines;
  for (const auto& word : words) {
    const auto name = word.substr(0, word.find('='));
    if (meant == commands.end() || !name.starts_with("--") || (*meant)->get_option_no_throw(name) != nullptr)
      continue;
    std::string having;
    for (const CLI::App* command : commands)
      if (command->get_option_no_throw(name) != nullptr && name != "--help")
        having += fmt::format("{}`tremolo {}`", having.empty() ? "" : ", ", command->get_name());
    if (!having.empty())
      lines += fmt::format("{} is an option of {}, not of `tremolo {}`\n", name, having, words.front());
  }
  return lines;
}

} // namespace

int run_command_line(int argc, char** argv, const std::string& program, const std::string& description,
                     const std::string& version, const std::string& greeting,
                     const std::function<void(Command&)>& add_commands) {
  if (argc <= 1) {
    std::fputs(greeting.c_str(), stdout);
    return refused;
  }
  CLI::App app(description, program);
  app.set_version_flag("--version", version);
  app.require_subcommand(1);
  Command commands(app);
  add_commands(commands);
  require_known(app, argv[1]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int status = app.exit(error);
    std::fputs(where_options_belong(app, std::vector<std::string>(argv + 1, argv + argc)).c_str(), stderr);
    return status == 0 ? 0 : refused;
  }
  return 0;
}

} // namespace tremolo::app
