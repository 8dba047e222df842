#pragma once

// Functions that read tables into the structs of a case. Missing or wrong values are reported and left empty.

#include "scene/case.hpp"
#include "scene/read/reader.hpp"
#include "scene/text/findings.hpp"

namespace tremolo::scene {

/// Motion, surface, half-space, soils, profile, damping and the numerics of free-field models.
void read_free_field(Document& document, Findings& findings, Case& scene);
/// The sides and the base; after read_free_field.
void read_boundary(Document& document, Findings& findings, Case& scene);
/// Numerics of the free-field models; after read_mesh, half of whose size is the default of element sizes.
void read_numerics(Document& document, Case& scene);
/// Soils; softening is scaled to [mesh] size if the mesh has been read.
void read_soils(Document& document, Findings& findings, Case& scene);
/// Layers of an array of tables, "profile" or that of a side; after read_soils.
std::vector<Layer> read_layers(Document& document, const char* name, Findings& findings, const Case& scene);
/// The realisation of [random_profile]; after read_layers, before the water table cuts the layers.
void read_random_profile(Document& document, Findings& findings, Case& scene);
/// The soil that a table's key `soil` names.
std::optional<std::size_t> soil_index(const TableReader& table, const std::vector<Soil>& soils,
                                      Findings& findings);
/// Mesh; before read_free_field.
void read_mesh(Document& document, Case& scene);
/// Time stepping of the domain.
void read_time(Document& document, Findings& findings, Case& scene);
/// The incident waves; after read_stages.
void read_motion(Document& document, Findings& findings, Case& scene);
/// The pulse or the record of [motion] or [stage.motion], whose kind is not known yet; nothing if there is
/// none.
std::optional<MotionSource> read_motion_source(const TableReader& table, const Case& scene,
                                               Findings& findings);
/// Stages, with the motions of all shakings but the first; before read_free_field.
void read_stages(Document& document, Findings& findings, Case& scene);
/// The models before each construction and after all of them; read after everything else that refers to
/// regions, structures and props.
void find_standing(Case& scene, Findings& findings);
/// Structures; after read_soils.
void read_structures(Document& document, Findings& findings, Case& scene);
/// A closed line that stands as a polygon, or else as a table with centre and radius; nothing if it stands
/// as neither.
std::optional<Outline> read_outline(const TableReader& table, std::string_view polygon,
                                    std::string_view circle_key, Findings& findings);
/// Friction and adhesion of a surface against each soil: its own, where no table of `against` names the soil.
std::vector<SoilContact> read_against(const TableReader& table, const std::vector<Soil>& soils,
                                      Findings& findings);
/// Linings; after read_soils.
void read_linings(Document& document, Findings& findings, Case& scene);
/// The structure that a table's key `structure` names.
std::optional<std::size_t> structure_index(const TableReader& table, const std::vector<Structure>& structures,
                                           Findings& findings);
/// Sections; after read_structures.
void read_sections(Document& document, Findings& findings, Case& scene);
/// Props; after read_structures.
void read_props(Document& document, Findings& findings, Case& scene);
/// Regions, structures, linings, sections, props and time stepping; after read_free_field.
void read_model(Document& document, Findings& findings, Case& scene);
/// The processes that run on other machines.
void read_hosts(Document& document, Case& scene);
/// Coupling, monitors, lines, sliding masses, output and verification.
void read_run(Document& document, Findings& findings, Case& scene);

/// Whether both of a pair of keys are there; reports the one that is missing.
bool complete(const TableReader& table, Findings& findings, const char* first, const char* second);

/// density and young + poisson or vs + vp of a table; zeros where they are missing.
materials::Elasticity read_elasticity(const TableReader& table, Findings& findings);

} // namespace tremolo::scene
