#include "app/commands.hpp"
#include "app/python.hpp"

#include <string>

namespace tremolo::app {
namespace {

void add_python_command(CLI::App& app, const std::string& name, const std::string& summary) {
  auto* command = app.add_subcommand(name, summary);
  command->prefix_command();
  command->set_help_flag();
  command->callback([command, name] { become_python(name, command->remaining()); });
}

} // namespace

void add_plot(CLI::App& app) {
  add_python_command(app, "plot",
                     "Pictures of a run: model, accelerations, shear bands, histories, energy, fronts");
  add_python_command(app, "timeline",
                     "What the processes of a run did when, drawn and in words: who waited for whom");
  add_python_command(app, "compare", "Pictures of two runs side by side");
  add_python_command(app, "failure", "When a shear band first connects the toe of a slope with its crest");
}

} // namespace tremolo::app
