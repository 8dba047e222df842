#pragma once

// The sub-commands of `tremolo`. Each adds itself to the command line; its callback does the work and leaves
// by an exception where it fails: main turns that into a message and an exit status.

#include "app/command_line.hpp"

namespace tremolo::app {

/// The command ends with this status; everything has been said already.
struct Exit {
  int status;
};

/// Exit status of a refused case file or command line.
inline constexpr int refused = 2;

void add_check(Command& app);
void add_conform(Command& app);
void add_cost(Command& app);
void add_explain(Command& app);
void add_join(Command& app);
void add_keygen(Command& app);
void add_deconvolve(Command& app);
void add_docs(Command& app);
void add_export(Command& app);
void add_import(Command& app);
void add_motion(Command& app);
void add_new(Command& app);
void add_plot(Command& app);
void add_wave(Command& app);
void add_verify(Command& app);
void add_resume(Command& app);
void add_run(Command& app);
void add_sbatch(Command& app);
void add_swap(Command& app);
void add_sweep(Command& app);
void add_column(Command& app);
void add_safety(Command& app);
void add_soiltest(Command& app);
void add_calibrate(Command& app);

} // namespace tremolo::app
