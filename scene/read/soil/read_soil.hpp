#pragma once

// One soil from its table, the same in cases, soil tests and the library.

#include "materials/hysteretic/backbone/curves.hpp"
#include "scene/read/read.hpp"

#include <filesystem>
#include <numbers>

namespace tremolo::scene {

/// One degree in rad: a case file gives angles in degrees.
inline constexpr double degree = std::numbers::pi / 180.0;

/// @param directory  that the name of a curve starts from
/// @param mesh_size  cell size to which softening is scaled, m; 0 leaves it unscaled
Soil read_soil(const NamedTable& soil, const std::filesystem::path& directory, double mesh_size,
               Findings& findings);

/// Reads a soil together with its properties in a case besides the law: pores, coefficient of earth pressure
/// at rest, damping.
Soil read_soil_of_case(NamedTable& soil, const Case& scene, Findings& findings);

/// Reads soil of the Mohr-Coulomb law, with its softening for cells of `mesh_size`.
Soil read_mohr_coulomb(const NamedTable& soil, double mesh_size, Findings& findings);

/// Reads a soil of PM4Sand or PDMY03.
Soil read_sand(const NamedTable& soil, const std::filesystem::path& directory, Findings& findings);

/// Reads a soil of the Drucker-Prager law or the clay of nested surfaces.
Soil read_hysteretic(const NamedTable& soil, const std::filesystem::path& directory, Findings& findings);

Soil read_plastic(const NamedTable& soil, const std::filesystem::path& directory, Findings& findings);

/// Reports a key that this model needs and others do not.
void need(const TableReader& table, std::string_view key, Findings& findings);

/// Whether a number, where it is given, lies in the range that this model has; reports it otherwise.
bool within(const TableReader& table, std::string_view key, const Range& range, std::string_view unit,
            Findings& findings);

/// Placeholder for a soil that cannot be read; its errors have been reported.
Soil placeholder(const std::string& name);

/// G/Gmax and damping that a soil's `curve` names.
/// @throws std::invalid_argument, saying what is wrong
materials::SoilCurves read_curve(const TableReader& table, const std::filesystem::path& directory);

} // namespace tremolo::scene
