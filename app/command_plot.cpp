#include "app/commands.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace tremolo::app {
namespace {

namespace fs = std::filesystem;

/// The Python package: where it was installed beside this program, otherwise in the source tree it was built
/// from.
fs::path python_package() {
  const fs::path installed = fs::canonical("/proc/self/exe").parent_path() / "../share/tremolo/python";
  return fs::exists(installed / "tremolo") ? installed.lexically_normal() : fs::path(TREMOLO_PYTHON_SOURCE);
}

/// Debian's interpreter has the packaged numpy, h5py and matplotlib; another one on the PATH need not.
std::string python() {
  constexpr const char* packaged = "/usr/bin/python3";
  return fs::exists(packaged) ? packaged : "python3";
}

/// Becomes `python3 -m tremolo COMMAND ARGUMENTS...`.
[[noreturn]] void run_python(const std::string& command, const std::vector<std::string>& arguments) {
  const char* inherited = std::getenv("PYTHONPATH");
  const std::string path =
      python_package().string() + (inherited != nullptr ? fmt::format(":{}", inherited) : "");
  setenv("PYTHONPATH", path.c_str(), 1);
  std::vector<std::string> words{python(), "-m", "tremolo", command};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (auto& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  execvp(argv.front(), argv.data());
  throw std::runtime_error(
      fmt::format("cannot start {}: {}", words.front(), std::generic_category().message(errno)));
}

void add_python_command(CLI::App& app, const std::string& name, const std::string& summary) {
  auto* command = app.add_subcommand(name, summary);
  command->prefix_command();
  command->set_help_flag();
  command->callback([command, name] { run_python(name, command->remaining()); });
}

} // namespace

void add_plot(CLI::App& app) {
  add_python_command(app, "plot",
                     "Pictures of a run: model, accelerations, shear bands, histories, energy, fronts");
  add_python_command(app, "compare", "Pictures of two runs side by side");
}

} // namespace tremolo::app
