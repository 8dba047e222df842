// tremolo: free fields and a large-deformation soil domain under seismic waves, coupled as processes.

#include "app/commands.hpp"
#include "app/crash_words.hpp"
#include "app/python.hpp"
#include "coupler/wire/error.hpp"
#include "scene/text/errors.hpp"

#include <cstdio>
#include <exception>

namespace {

/// What a newcomer needs.
constexpr const char* greeting =
    "tremolo: a large-deformation soil domain shaken through its boundaries by free-field models\n\n"
    "  tremolo new my_slope                a case folder to begin from (--like box, level_ground, tunnel, "
    "...)\n"
    "  tremolo explain my_slope/case.toml  what is wrong with it, what it will run and cost\n"
    "  tremolo run my_slope/case.toml      run it; results go to runs/my_slope\n"
    "  tremolo report runs/my_slope        one HTML page of the results\n"
    "  tremolo swap my_slope/case.toml     what another free-field model changes\n\n"
    "All commands: tremolo --help. One of them: tremolo run --help.\n";

void add_commands(tremolo::app::Command& program) {
  tremolo::app::add_check(program);
  tremolo::app::add_conform(program);
  tremolo::app::add_explain(program);
  tremolo::app::add_join(program);
  tremolo::app::add_keygen(program);
  tremolo::app::add_docs(program);
  tremolo::app::add_export(program);
  tremolo::app::add_import(program);
  tremolo::app::add_motion(program);
  tremolo::app::add_deconvolve(program);
  tremolo::app::add_new(program);
  tremolo::app::add_plot(program);
  tremolo::app::add_wave(program);
  tremolo::app::add_verify(program);
  tremolo::app::add_run(program);
  tremolo::app::add_sbatch(program);
  tremolo::app::add_resume(program);
  tremolo::app::add_swap(program);
  tremolo::app::add_sweep(program);
  tremolo::app::add_cost(program);
  tremolo::app::add_column(program);
  tremolo::app::add_safety(program);
  tremolo::app::add_soiltest(program);
  tremolo::app::add_calibrate(program);
}

} // namespace

int main(int argc, char** argv) {
  tremolo::app::explain_crashes(argc, argv);
  try {
    tremolo::app::share_python_package();
    return tremolo::app::run_command_line(
        argc, argv, "tremolo",
        "tremolo: a large-deformation soil domain shaken through its boundaries by free-field models",
        "tremolo " TREMOLO_VERSION, greeting, add_commands);
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
