#include "scene/plan/output/output_size.hpp"

#include "mesh/cell_size.hpp"
#include "scene/plan/output/intervals.hpp"

#include "base/dataset_size.hpp"
#include "mpm_domain/spec/output_columns.hpp"
#include "scene/meeting_boxes.hpp"
#include "scene/soils/domain_soils.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <vector>

namespace tremolo::scene {

namespace {

// Size of run.h5 without a row or a frame: attributes and room for the links of groups, including the groups
// /contact and /structures beside the frames of soil. Room for a link is used up by more than 4,096 frames.
constexpr double empty_run_bytes = 180e3;
constexpr double empty_part_bytes = 170e3;
constexpr double frame_bytes = 300.0; // its group, time and link
constexpr double xdmf_field_bytes = 300.0;
constexpr double other_tables_bytes = 80e3; // the plan, timings, processes and the timeline
constexpr std::size_t name_bytes = 64;      // of a column and its unit, in texts of equal length

/// State variables of all laws; one of several soils is one array.
std::size_t state_variable_count(const Case& scene) {
  std::set<std::string_view> names;
  for (const Soil& soil : domain_soils(scene))
    for (const materials::StateVariable& variable : materials::state_variables(soil.law))
      if (!variable.internal)
        names.insert(variable.name);
  return names.size();
}

/// Numbers of a particle in each array of a frame; the first are written always.
std::vector<double> particle_arrays(const Case& scene) {
  std::vector<double> arrays{2.0, 0.5}; // position; soil, an integer of 4 bytes
  if (!scene.mesh.refine.empty())
    arrays.push_back(1.0); // size
  for (const OutputField field : scene.output.fields) {
    if (field == OutputField::state)
      arrays.insert(arrays.end(), state_variable_count(scene), 1.0);
    else
      arrays.push_back(static_cast<double>(row(field).components));
    if (field == OutputField::stress)
      arrays.push_back(1.0); // the volume
  }
  return arrays;
}

/// A frame's bytes in run.h5 and run.xdmf.
double frame_of_particles(const Case& scene, double particles) {
  double bytes = frame_bytes + xdmf_field_bytes;
  for (const double numbers : particle_arrays(scene)) {
    const double values = 8.0 * numbers * particles;
    bytes += values + array_overhead_bytes(values) + xdmf_field_bytes;
  }
  return bytes;
}

/// Nodes at which a body may touch soil: those of the cells that its outline crosses, in rows of three.
double most_contact_nodes(const Case& scene) {
  double nodes = 0.0;
  for (const Structure& structure : scene.structures)
    nodes += 3.0 * (perimeter(structure.outline.corners) / contact_cell_size(scene) + 4.0);
  return nodes;
}

double frame_of_contact(const Case& scene) {
  if (scene.structures.empty())
    return 0.0;
  double bytes = frame_bytes;
  for (const mpm_domain::OutputArray& array : mpm_domain::contact_arrays) {
    const double values = static_cast<double>(array.components * array.bytes) * most_contact_nodes(scene);
    bytes += values + array_overhead_bytes(values);
  }
  return bytes;
}

bool has_elastic_structure(const Case& scene) {
  return std::ranges::any_of(scene.structures,
                             [](const Structure& one) { return one.stiffness.has_value(); });
}

/// Additional size of elastic structures, whose particles are already counted as if they were soil.
double frame_of_structures(const Case& scene) {
  constexpr auto arrays = static_cast<double>(mpm_domain::structure_arrays.size());
  return has_elastic_structure(scene) ? frame_bytes + arrays * array_overhead_bytes(0.0) : 0.0;
}

/// Segments of a lining's outer face, at most: they end at corners that turn by more than 20 degrees, of
/// which a convex outline has fewer than 18.
std::size_t most_segments(const PlannedLining& lining) {
  return static_cast<std::size_t>(lining.segments) + 18;
}

/// Points of a polygon whose edges are cut into pieces of a length at most.
std::size_t points_of(const std::vector<Point>& corners, double spacing) {
  return corners.size() + static_cast<std::size_t>(perimeter(corners) / spacing);
}

double histories(const Case& scene, const Plan& plan) {
  const auto rows = static_cast<std::size_t>(most_rows(scene, plan.dt)); // the last moment's comes on top
  const auto table = [&](std::size_t columns) { return growing_table_bytes(columns, rows, name_bytes); };
  const std::size_t point = mpm_domain::followed_point_columns.size() +
                            (scene.water ? mpm_domain::followed_water_columns.size() : 0);
  double bytes = table(1 + mpm_domain::energy_columns.size());
  if (scene.boundary.base_is_rigid())
    bytes += table(mpm_domain::table_columns.size());
  for (const Monitor& monitor : scene.monitors)
    bytes +=
        table(monitor.structure ? std::max(mpm_domain::body_monitor_columns.size(), 1 + point) : 1 + point);
  for (const Line& line : scene.lines)
    bytes += table(1 + point * points_along(line.from, line.to, line.spacing).size());
  bytes += static_cast<double>(scene.sliding_masses.size()) * table(mpm_domain::sliding_mass_columns.size());
  bytes += static_cast<double>(scene.structures.size()) * table(mpm_domain::body_columns.size());
  for (const Section& section : scene.sections)
    bytes += table(1 + section.lines.size() * mpm_domain::section_columns.size());
  bytes += static_cast<double>(scene.props.size()) * table(mpm_domain::prop_columns.size());
  for (const PlannedLining& lining : plan.linings)
    bytes += table(1 + lining.elements * mpm_domain::lining_element_columns.size() +
                   most_segments(lining) * mpm_domain::lining_segment_columns.size());
  const std::size_t faces = most_faces(scene);
  const std::size_t vectors = mpm_domain::numbers_of_face / 2;
  bytes +=
      static_cast<double>(vectors) * growing_table_bytes(2 * faces, rows) + growing_table_bytes(1, rows) +
      static_cast<double>(faces) * ((5 + mpm_domain::drift_columns.size()) * sizeof(double) + 2 * name_bytes);
  const auto frames = static_cast<std::size_t>(plan.frames) + 1;
  const double spacing = contact_cell_size(scene);
  for (const Structure& structure : scene.structures)
    if (structure.stiffness)
      bytes +=
          growing_table_bytes(1 + 2 * (points_of(structure.outline.corners, spacing) +
                                       (structure.hole ? points_of(structure.hole->corners, spacing) : 0)),
                              frames, name_bytes);
  return bytes;
}

/// Points along the outlines of all structures and their holes, axes of linings, and ends of props.
double outline_points(const Case& scene, const Plan& plan) {
  std::size_t points = 2 * scene.props.size();
  for (const PlannedLining& lining : plan.linings)
    points += lining.elements;
  const auto add = [&](const std::vector<Point>& corners, bool bends) {
    points += bends ? points_of(corners, contact_cell_size(scene)) : corners.size();
  };
  for (const Structure& structure : scene.structures) {
    add(structure.outline.corners, structure.stiffness.has_value());
    if (structure.hole)
      add(structure.hole->corners, structure.stiffness.has_value());
  }
  return static_cast<double>(points);
}

/// Size of ParaView's view of run.h5: virtual datasets that name the arrays of each frame, numbers of the
/// particles, and places of faces and outlines.
double paraview_bytes(const Case& scene, const Plan& plan, double frames) {
  constexpr double array_bytes = 6e3;     // a virtual dataset without the arrays that it names
  constexpr double naming_bytes = 100.0;  // one of these
  constexpr double topology_arrays = 9.0; // of particles and lines
  constexpr double point_bytes = 3.0 * 8.0;
  constexpr double line_bytes = 2.0 * point_bytes + 40.0; // a face with its entries in the topology
  const double arrays = static_cast<double>(particle_arrays(scene).size()) + topology_arrays;
  return array_bytes * (arrays + topology_arrays) + frames * arrays * (naming_bytes + 8.0) +
         8.0 * static_cast<double>(plan.particles) + line_bytes * static_cast<double>(most_faces(scene)) +
         outline_points(scene, plan) * (frames * point_bytes + 20.0);
}

} // namespace

std::size_t most_faces(const Case& scene) {
  const Box& box = scene.mesh.box;
  const auto finest = [&](const Box& edge) {
    int level = 0;
    for (const Refinement& refine : scene.mesh.refine)
      if (meet(edge, refine.box))
        level = std::max(level, refine.level);
    return mesh::cell_size(scene.mesh.size, level) / scene.mesh.particles_per_cell;
  };
  const double near = 4.0 * scene.mesh.size; // finer cells reach beyond their box by as much at most
  const auto cells = [](double length, double size) {
    return static_cast<std::size_t>(std::ceil(length / size));
  };
  return cells(box.height(), finest({box.x_min, box.y_min, box.x_min + near, box.y_max})) +
         cells(box.height(), finest({box.x_max - near, box.y_min, box.x_max, box.y_max})) +
         cells(box.width(), finest({box.x_min, box.y_min, box.x_max, box.y_min + near})) + 1;
}

double output_bytes(const Case& scene, const Plan& plan) {
  const double frames = static_cast<double>(plan.frames) + 1.0; // and the last moment's
  return empty_run_bytes + (scene.structures.empty() ? 0.0 : empty_part_bytes) +
         (has_elastic_structure(scene) ? empty_part_bytes : 0.0) + static_cast<double>(scene.text.size()) +
         other_tables_bytes + histories(scene, plan) + paraview_bytes(scene, plan, frames) +
         frames * (frame_of_particles(scene, static_cast<double>(plan.particles)) + frame_of_contact(scene) +
                   frame_of_structures(scene));
}

} // namespace tremolo::scene
