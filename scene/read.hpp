#pragma once

// From tables to the structs of a case. What is missing or wrong is reported and left at its empty value.

#include "scene/case.hpp"
#include "scene/findings.hpp"
#include "scene/reader.hpp"

namespace tremolo::scene {

/// Motion, surface, half-space, profile and damping.
void read_free_field(Document& document, Findings& findings, Case& scene);
/// The free field, columns and boundary.
void read_field(Document& document, Findings& findings, Case& scene);
/// Soils, regions, mesh, time stepping and stages; after read_field.
void read_model(Document& document, Findings& findings, Case& scene);
/// Coupling, monitors, output and verification.
void read_run(Document& document, Case& scene);

/// density and young + poisson or vs + vp of a table; zeros where they are missing.
materials::Elasticity read_elasticity(const TableReader& table, Findings& findings);

} // namespace tremolo::scene
