#pragma once

// What `tremolo soiltest` writes. OUT.h5 is made of tables (a group a table, a dataset a column, its unit in
// the attribute `unit`), SI units, tension positive unless a name says otherwise:
//
//     /about              one row: title, soil (a name or ""), law, library (or ""), kind, drainage, loading,
//                         vertical_stress (Pa, compression positive), k0, shear_bias (tau_0 over it),
//                         test_file (its whole text)
//     /parameters         a row a parameter in force: name, value, unit, meaning, origin
//     /tests/000/history  a row an increment that is kept: step, cycle, eps_xx, eps_yy, eps_zz, gamma_xy,
//                         sig_xx, sig_yy, sig_zz, sig_xy (effective), p, q (of the law, compression positive,
//                         those of /lines), p_inplane, u, ru (excess pore pressure and its ratio), then the
//                         state variables by name
//     /tests/001/...      the next stress ratio or amplitude, and so on
//     /summary            a row a test: test ("000"), stress_ratio, strain_amplitude, cycles_1pc, cycles_3pc,
//                         cycles_5pc, cycles_ru98 (NaN where not reached), largest_ru, peak_q, steps, seconds
//     /lines/<name>       lines in the p-q plane, points from p = 0 on: p, q; names: critical_state,
//                         bounding, dilation, phase_transformation, failure; only those that the law has
//     /strength_curve     cyclic tests at several stress ratios: stress_ratio, cycles_1pc, cycles_3pc,
//                         cycles_5pc, cycles_ru98
//     /strength_target    the curve of Idriss and Boulanger where the soil has a relative density: cycles,
//                         stress_ratio
//     /modulus_curve      strain-controlled cycles: strain_amplitude, shear_modulus (Pa, secant),
//                         modulus_ratio, damping
//
// A test of one kind of loading has the tables that it can have; the others are absent.
//
// OUT.csv is the history of a single test, the columns of /tests/000/history in that order.

#include "app/soiltest_run.hpp"
#include "results/run_file.hpp"

#include <filesystem>
#include <vector>

namespace tremolo::app {

std::vector<results::NamedTable> soiltest_tables(const scene::SoilTestFile& file, const SoilTestRun& run);

/// Refuses a name that is neither .h5 nor .csv, and .csv for more than one test.
/// @throws std::runtime_error saying so
void check_output_name(const std::filesystem::path& out, const scene::SoilTestFile& file);

/// By the extension of the name.
/// @throws std::runtime_error where the file cannot be written
void write_soiltest(const std::filesystem::path& out, const scene::SoilTestFile& file,
                    const SoilTestRun& run);

} // namespace tremolo::app
