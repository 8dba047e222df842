#pragma once

// What the processes of a run do first, in one process: everything is built as tremolo-wave, tremolo-column
// and tremolo-domain build it, and makes three steps.

#include "app/free_field/column/column_ground.hpp"
#include "scene/case.hpp"

namespace tremolo::testing {

/// Starts every process of a case.
/// @throws what a process would end with
void start_processes(const scene::Case& scene);

/// Starts `tremolo column` and computes its first times.
/// @throws what it would end with
void run_column(const app::ColumnGround& ground);

} // namespace tremolo::testing
