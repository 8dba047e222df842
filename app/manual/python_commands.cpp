#include "app/manual/python_commands.hpp"

#include "app/python.hpp"
#include "app/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <fstream>
#include <stdexcept>

namespace tremolo::app {
namespace {

using Json = nlohmann::json;

OptionRow option_row(const Json& option) {
  return {.names = option.at("names"),
          .value = option.at("value"),
          .description = option.at("description"),
          .choices = option.at("choices"),
          .has_place = option.at("has_place"),
          .required = option.at("required")};
}

Json python_table() {
  const TemporaryFolder folder;
  const auto file = folder.path() / "commands.json";
  if (run_python("command-table", {file.string()}) != 0)
    throw std::runtime_error("the Python package does not say what its commands take");
  return Json::parse(std::ifstream(file));
}

} // namespace

void add_python_options(CommandTable& table) {
  const Json known = python_table();
  for (CommandRow& command : table.commands)
    if (command.relay)
      for (const Json& option : known.at(command.name))
        command.options.push_back(option_row(option));
}

} // namespace tremolo::app
