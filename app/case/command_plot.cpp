#include "app/commands.hpp"
#include "app/python.hpp"

#include <string>
#include <vector>

namespace tremolo::app {
namespace {

void add_python_command(Command& app, const std::string& name, const std::string& summary) {
  app.add_relay(name, summary, [name](const std::vector<std::string>& rest) {
    if (const int status = run_python(name, rest); status != 0)
      throw Exit{status};
  });
}

} // namespace

void add_plot(Command& app) {
  add_python_command(app, "plot",
                     "Pictures of a run: model, accelerations, shear bands, histories, energy, fronts");
  add_python_command(app, "timeline",
                     "What the processes of a run did when, drawn and in words: who waited for whom");
  add_python_command(app, "compare", "Pictures of two runs side by side");
  add_python_command(
      app, "report",
      "One HTML file of a run, of several side by side, or of studies: frames that play, charts that zoom");
  add_python_command(
      app, "watch",
      "The report of a run in a browser of this machine while the run goes on: histories, frames, abort");
  add_python_command(
      app, "extract",
      "Tables of a run: histories, profiles along lines, spectral ratios, Newmark's displacement");
  add_python_command(app, "failure",
                     "When a shear band first connects the toe of a slope with its crest, or two points");
}

} // namespace tremolo::app
