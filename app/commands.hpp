#pragma once

// The sub-commands of `tremolo`. Each adds itself to the command line; its callback does the work and leaves
// by an exception where it fails: main turns that into a message and an exit status.

#include <CLI/CLI.hpp>

namespace tremolo::app {

/// The command ends with this status; everything has been said already.
struct Exit {
  int status;
};

/// Exit status of a refused case file or command line.
inline constexpr int refused = 2;

void add_check(CLI::App& app);
void add_conform(CLI::App& app);
void add_cost(CLI::App& app);
void add_explain(CLI::App& app);
void add_join(CLI::App& app);
void add_keygen(CLI::App& app);
void add_docs(CLI::App& app);
void add_export(CLI::App& app);
void add_import(CLI::App& app);
void add_motion(CLI::App& app);
void add_plot(CLI::App& app);
void add_wave(CLI::App& app);
void add_verify(CLI::App& app);
void add_resume(CLI::App& app);
void add_run(CLI::App& app);
void add_sbatch(CLI::App& app);
void add_swap(CLI::App& app);
void add_column(CLI::App& app);
void add_soiltest(CLI::App& app);
void add_calibrate(CLI::App& app);

} // namespace tremolo::app
