#pragma once

// The levels of a case's mesh, coarse to fine, as the domain will build it. A mesh without [[refine]] has
// one.

#include "mesh/quadtree.hpp"
#include "scene/case.hpp"

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace tremolo::scene {

/// The step that a material allows, s.
struct MaterialStep {
  double critical = 0.0; ///< 0.65 h/c_p, shortened by viscous damping (mpm_domain/spec/limits.hpp)
  double undamped = 0.0; ///< without the damping
};

struct Level {
  double cell_size = 0.0;     ///< m
  double particle_size = 0.0; ///< m
  double cells = 0.0;         ///< of one level: of the padded grid; of several: those in the model's box
  double particles = 0.0;
  double nodes = 0.0;
  /// Time steps of the soils and elastic structures whose particles touch cells of this level, by their names
  /// in messages.
  std::map<std::string, MaterialStep> steps;
  double critical_dt = 0.0; ///< the least of these, s; infinite where there are none
  double dt = 0.0;          ///< that they take, s; set by the plan
};

/// The cells of the domain's mesh, those around the model's box included; for a mesh with a size and a box.
mesh::Quadtree quadtree(const Case& scene);

/// Requires a mesh with a size, a box and soils.
std::vector<Level> levels(const Case& scene);

/// 0.65 h/c_p of an elastic structure on cells of a size (m), s.
double critical_step(const Structure& structure, double cell_size);

/// "60, 30, 15 on cells of 1, 0.5, 0.25 m": a value that goes with the cell size (m), on each level.
std::string by_level(std::span<const Level> levels, const std::function<double(double)>& value);

} // namespace tremolo::scene
