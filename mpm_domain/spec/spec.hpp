#pragma once

#include "coupler/eq6/boundary_traction.hpp"
#include "materials/law/law.hpp"
#include "mesh/quadtree.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

using eq6::Vector;

/// An axis-parallel rectangle, m.
using Box = mesh::Rectangle;

struct Soil {
  std::string name;
  materials::Law law; ///< on cells of level 0
  /// On cells of level 1, 2, ... where the law depends on their size; where there is none, `law`.
  std::vector<materials::Law> finer_laws = {};
};

/// A polygon of one soil; where polygons overlap, the later one wins.
struct Region {
  std::size_t soil = 0; ///< index into Spec::soils
  std::vector<Vector> polygon;
};

enum class Side { left, right, base };

/// How velocity travels between particles and grid.
enum class Transfer {
  apic,      ///< affine particle-in-cell (Jiang et al. 2015): angular momentum kept, noise filtered
  flip,      ///< particles take the grid's acceleration; no dissipation, no filter
  fmpm,      ///< PIC by an approximate inverse of the full mass matrix (full_mass_matrix.hpp): noise filtered
  pic_blend, ///< FLIP blended with PIC so that the difference decays with a time constant
};

/// When stress is updated in a step: last, first, or last with remapped velocity.
enum class StepOrder { usl, usf, musl };

/// What becomes of the particles' boxes where soil is strained.
enum class ParticleBoxes {
  fixed,     ///< they keep their size: uGIMP
  deforming, ///< they follow it (particle_boxes.hpp); not with usf
};

/// Orders of FMPM(k) from 2 to this: every one more costs a transfer there and back.
inline constexpr int highest_fmpm_order = 10;

/// The numerical scheme of the domain.
struct Scheme {
  Transfer transfer = Transfer::apic;
  StepOrder order = StepOrder::musl;
  double blend_time = 0.0;  ///< time constant of pic_blend, s
  int fmpm_order = 3;       ///< k of FMPM(k), 2 to highest_fmpm_order; not with usl
  double fraction = 0.5;    ///< of the critical time step, in (0, 1]
  std::optional<double> dt; ///< a fixed time step instead, s
  /// Each level of a graded mesh takes a step of its own, half of the coarser one's (subcycling.hpp);
  /// fraction and dt are of the coarsest one's. For the transfers apic and flip and the order musl.
  bool subcycle = false;
};

/// Everything the domain is built from.
struct Spec {
  Box box;                    ///< model; its left, right and lower edges carry boundary faces
  double cell_size = 0.0;     ///< h, of the coarsest cells, m
  int particles_per_cell = 2; ///< per direction, 1 to 4
  ParticleBoxes boxes = ParticleBoxes::fixed;
  /// Where cells are finer. A box that reaches an edge of the model goes on beyond it.
  std::vector<mesh::Refinement> refine;
  bool join_particles = false; ///< that have left finer cells, four to one (joining.hpp)
  double gravity = 0.0;        ///< m/s2, downwards
  std::vector<Soil> soils;
  std::vector<Region> regions;
  Scheme scheme;
  /// The domain repeats itself beyond its sides, which then carry no faces; it is a whole number of cells
  /// wide.
  bool periodic_sides = false;
  /// Sides whose scattered waves a matched layer takes up instead of dashpots, and its depth in cells.
  std::vector<Side> matched_sides;
  int layer_cells = 10;
  /// Ground below the base, where it is not the soil that the model ends with: what the base's dashpots or
  /// matched layer stand for.
  std::optional<materials::Elasticity> below_base;
  int threads = 1;
};

} // namespace tremolo::mpm_domain
