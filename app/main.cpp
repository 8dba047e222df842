// tremolo: free fields and a large-deformation soil domain under seismic waves, coupled as processes.

#include "app/commands.hpp"
#include "app/crash_words.hpp"
#include "app/python.hpp"
#include "coupler/wire/error.hpp"
#include "scene/text/errors.hpp"

#include <cstdio>
#include <exception>

namespace {

/// Help for a newcomer.
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
  using namespace tremolo::app;
  program.begin_group("Run a case");
  add_run(program);
  add_new(program);
  add_check(program);
  add_explain(program);
  add_resume(program);
  program.begin_group("Look at results");
  add_plot(program);
  add_verify(program);
  program.begin_group("Study a case");
  add_swap(program);
  add_sweep(program);
  add_cost(program);
  add_safety(program);
  program.begin_group("Ground motion and free fields");
  add_motion(program);
  add_column(program);
  add_wave(program);
  add_deconvolve(program);
  program.begin_group("Test a soil");
  add_soiltest(program);
  add_calibrate(program);
  program.begin_group("Free fields of other programs");
  add_conform(program);
  add_import(program);
  add_export(program);
  program.begin_group("Other machines");
  add_sbatch(program);
  add_join(program);
  add_keygen(program);
  program.begin_group("This manual");
  add_docs(program);
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
