// tremolo: free fields and a large-deformation soil domain under seismic waves, coupled as processes.

#include "app/commands.hpp"
#include "app/python.hpp"
#include "scene/text/errors.hpp"
#include "scene/text/nearest.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

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
  std::fprintf(
      stderr, "tremolo: '%.*s' is no command, %s\n", static_cast<int>(word.size()), word.data(),
      tremolo::scene::suggestion(word, std::vector<std::string_view>(names.begin(), names.end())).c_str());
  throw tremolo::app::Exit{tremolo::app::refused};
}

int run(int argc, char** argv) {
  CLI::App app("tremolo: a large-deformation soil domain shaken through its boundaries by free-field models",
               "tremolo");
  app.set_version_flag("--version", "tremolo " TREMOLO_VERSION);
  app.require_subcommand(1);
  tremolo::app::add_check(app);
  tremolo::app::add_conform(app);
  tremolo::app::add_explain(app);
  tremolo::app::add_join(app);
  tremolo::app::add_keygen(app);
  tremolo::app::add_docs(app);
  tremolo::app::add_export(app);
  tremolo::app::add_import(app);
  tremolo::app::add_motion(app);
  tremolo::app::add_plot(app);
  tremolo::app::add_wave(app);
  tremolo::app::add_verify(app);
  tremolo::app::add_run(app);
  tremolo::app::add_sbatch(app);
  tremolo::app::add_resume(app);
  tremolo::app::add_swap(app);
  tremolo::app::add_cost(app);
  tremolo::app::add_column(app);
  tremolo::app::add_soiltest(app);
  tremolo::app::add_calibrate(app);
  if (argc > 1)
    require_known(app, argv[1]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : tremolo::app::refused;
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  try {
    tremolo::app::share_python_package();
    return run(argc, argv);
  } catch (const tremolo::app::Exit& exit) {
    return exit.status;
  } catch (const tremolo::scene::CaseErrors& errors) {
    std::fprintf(stderr, "%s\n", errors.what());
    return tremolo::app::refused;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tremolo: %s\n", error.what());
    return 1;
  }
}
