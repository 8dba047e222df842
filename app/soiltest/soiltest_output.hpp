#pragma once

// Output of `tremolo soiltest`. OUT.h5 consists of tables (a group a table, a dataset a column, its unit in
// the attribute `unit`), SI units, tension positive unless a name says otherwise:
//
//     /about              one row: title, soil (a name or ""), law, library (or ""), kind, drainage, loading,
//                         vertical_stress (Pa, compression positive), k0, shear_bias (tau_0 over it),
//                         stress_path ("in_plane" or "in_space": which p and q those of the histories are,
//                         see app/soiltest/soiltest_lines.hpp), test_file (its whole text)
//     /parameters         a row a parameter in force: name, value, unit, meaning, origin
//     /tests/000/history  a row an increment that is kept: step, cycle, eps_xx, eps_yy, eps_zz, gamma_xy,
//                         sig_xx, sig_yy, sig_zz, sig_xy (effective), p, q (of the law, compression positive,
//                         those of /lines), p_inplane, u, ru (excess pore pressure and its ratio), then the
//                         state variables by name
//     /tests/000/loops    strain-controlled cycles, a row a closed loop: strain_amplitude, cycle (1 for the
//                         first of its amplitude), shear_strain (gamma, engineering), shear_modulus (Pa),
//                         damping, ru (at its end)
//     /tests/001/...      the next stress ratio or amplitude, and so on
//     /summary            a row a test: test ("000"), stress_ratio, strain_amplitude, cycles_1pc, cycles_3pc,
//                         cycles_5pc, cycles_ru98 (NaN where not reached), largest_ru (NaN where it means
//                         nothing), largest_missing_stress (Pa, by which the stress held by the apparatus was
//                         missed), peak_q, steps, seconds
//     /lines/<name>       lines in the p-q plane, points from p = 0 on: p, q; names: critical_state,
//                         bounding, dilation, phase_transformation, failure; only those that the law has
//     /strength_curve     cyclic tests at several stress ratios: stress_ratio, cycles_1pc, cycles_3pc,
//                         cycles_5pc, cycles_ru98
//     /strength_target    the curve of Idriss and Boulanger where the soil has a relative density: cycles,
//                         stress_ratio
//     /modulus_curve      strain-controlled cycles: strain_amplitude (gamma_xy or eps_a), shear_strain
//     (gamma),
//                         shear_modulus (Pa, secant, tau/gamma), modulus_ratio, damping
//
// A test of one kind of loading has the tables that it can have; the others are absent.
//
// OUT.csv is the history of a single test, the columns of /tests/000/history in that order.

#include "app/soiltest/soiltest_run.hpp"
#include "results/run_file.hpp"

#include <filesystem>
#include <vector>

namespace tremolo::app {

std::vector<results::NamedTable> soiltest_tables(const scene::SoilTestFile& file, const SoilTestRun& run);

/// Refuses a name that is neither .h5 nor .csv, .csv for more than one test, and a place that must not be
/// written to.
/// @param plot  whether a picture goes beside it
/// @throws std::runtime_error saying so
void check_output(const std::filesystem::path& out, const scene::SoilTestFile& file, bool plot);

/// Writes the format given by the extension of the name.
/// @throws std::runtime_error where the file cannot be written
void write_soiltest(const std::filesystem::path& out, const scene::SoilTestFile& file,
                    const SoilTestRun& run);

} // namespace tremolo::app
