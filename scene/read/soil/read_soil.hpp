#pragma once

// One soil from its table, the same in cases, soil tests and the library.

#include "materials/hysteretic/backbone/curves.hpp"
#include "materials/law/parameter.hpp"
#include "scene/read/read.hpp"

#include <filesystem>
#include <span>
#include <string_view>

namespace tremolo::scene {

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

/// Reads soil of a law with a backbone.
Soil read_hysteretic(const NamedTable& soil, const std::filesystem::path& directory, Findings& findings);

/// Reads soil of a law that fields give, or the clay of nested surfaces.
Soil read_plastic(const NamedTable& soil, const std::filesystem::path& directory, Findings& findings);

/// Reports a key that this model needs and others do not.
void need(const TableReader& table, std::string_view key, Findings& findings);

/// Whether the numbers that the model's law takes are there and in its ranges; reports what is not.
bool sound_numbers(const TableReader& table, SoilModel model, Findings& findings);

/// Puts the numbers that a file gives into the fields of a law.
void read_fields(materials::Law& law, const TableReader& table);

/// Puts the numbers that a file gives into what a law is made from.
template <class Input>
void read_into(Input& input, std::span<const materials::InputField<Input>> fields, const TableReader& table) {
  for (const auto& [text, member] : fields)
    if (const auto number = table.optional_number(text.name))
      member(input) = *number * materials::in_law(text);
}

/// Placeholder for a soil that cannot be read; its errors have been reported.
Soil placeholder(const std::string& name);

/// G/Gmax and damping that a soil's `curve` names.
/// @throws std::invalid_argument, saying what is wrong
materials::SoilCurves read_curve(const TableReader& table, const std::filesystem::path& directory);

} // namespace tremolo::scene
