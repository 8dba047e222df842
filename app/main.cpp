// tremolo: free fields and a large-deformation soil domain under seismic waves, coupled as processes.

#include "app/commands.hpp"
#include "app/python.hpp"
#include "coupler/wire/error.hpp"
#include "scene/text/errors.hpp"

#include <cstdio>
#include <exception>

namespace {

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
    std::fprintf(stderr, "tremolo: %s\n", tremolo::coupler::message_of(error).c_str());
    return 1;
  }
}
