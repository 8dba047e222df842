#pragma once

#include "materials/law/law.hpp"
#include "materials/relaxation/relaxation.hpp"
#include "materials/water/pore_water.hpp"
#include "materials/water/soil_clock.hpp"
#include "mesh/quadtree.hpp"
#include "mpm_domain/fields/particle_fields.hpp"
#include "mpm_domain/spec/growth.hpp"
#include "mpm_domain/spec/lining.hpp"
#include "mpm_domain/spec/numerics.hpp"
#include "mpm_domain/spec/prop.hpp"
#include "mpm_domain/spec/section.hpp"
#include "mpm_domain/spec/structure.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// An axis-parallel rectangle, m.
using Box = mesh::Rectangle;

struct Soil {
  std::string name;
  materials::Law law; ///< on cells of level 0
  /// On cells of level 1, 2, ... where the law depends on their size; where there is none, `law`.
  std::vector<materials::Law> finer_laws = {};
  /// beta of the viscous stress beta D_e : d eps/dt, s; 0: none.
  double damping_time = 0.0;
  /// The pores of soil that may lie below a water table. The density of its law is then the saturated one.
  std::optional<materials::PoreSpace> pores = {};
  materials::Relaxation relaxation = {}; ///< mechanisms of constant damping, in the place of damping_time
  double mass_damping = 0.0;             ///< alpha, 1/s, on velocities relative to Spec::rock_motion; 0: none
};

/// Levels of the water at both sides of a model: of the table in the ground there, or of free water over it,
/// m.
struct SideLevels {
  double left = 0.0;
  double right = 0.0;
};

/// Ground water before it is disturbed (head/head.hpp). It has a level table, unless `line` or `seepage` say
/// otherwise.
struct GroundWater {
  double level = 0.0; ///< y of a level table, m
  materials::PoreFluid fluid;
  /// Corners of a phreatic line that is not level, from left to right: water rests below it.
  std::vector<Vector> line = {};
  /// Water flows steadily from one side to the other.
  std::optional<SideLevels> seepage = {};
  /// Soil above a level table is wet up to here, since it could not drain, m.
  std::optional<double> still_wet = {};
};

/// A polygon of one soil; where polygons overlap, the later one wins.
struct Region {
  std::size_t soil = 0; ///< index into Spec::soils
  std::vector<Vector> polygon;
  std::vector<double> cuts = {}; ///< y below which the next of the soils lies, from the top down, m
};

/// Springs beside the dashpots of a side (boundary/springs/ground_springs.hpp).
struct SideSprings {
  Side side = Side::left;
  double across = 1.0; ///< a_n
  double along = 0.5;  ///< a_t
  Vector centre;       ///< that R is measured from, m
  bool lags = false;
  /// The source of the free field gives these springs one of their own, behind those of all faces: where the
  /// dashpots of the base see the incident wave alone.
  bool own_field = false;
};

/// A load on the surface of the soil (boundary/load/surface_loads.hpp), per unit of its length.
struct SurfaceLoad {
  double x_min = 0.0; ///< where it begins and ends at the start, m
  double x_max = 0.0;
  double pressure = 0.0;             ///< onto the surface, Pa
  double shear = 0.0;                ///< along it, towards +x, Pa
  std::optional<Growth> growth = {}; ///< it comes while the ground is in motion; none: in a static stage
};

/// A load on a structure (contact/structure_loads.hpp).
struct StructureLoad {
  std::string structure;             ///< its name
  Vector force;                      ///< at its centroid, N/m
  std::optional<Growth> growth = {}; ///< as of a SurfaceLoad
};

/// Soil that is placed and removed while the ground is in motion (earthworks/earthworks.hpp).
struct Earthwork {
  Growth growth;
  std::vector<Region> place;
  std::vector<Region> remove; ///< each of which is among `regions`, or among `place` of an earlier one
};

/// Everything the domain is built from.
struct Spec {
  Box box;                    ///< model; its left, right and lower edges carry boundary faces
  double cell_size = 0.0;     ///< h, of the coarsest cells, m
  int particles_per_cell = 2; ///< per direction, 1 to 4
  ParticleBoxes boxes = ParticleBoxes::fixed;
  /// Boxes with finer cells. A box that reaches an edge of the model continues beyond it.
  std::vector<mesh::Refinement> refine;
  double gravity = 0.0; ///< m/s2, downwards
  std::optional<GroundWater> water = {};
  std::vector<Soil> soils;
  std::vector<Region> regions;
  std::vector<Structure> structures = {};
  std::vector<Lining> linings = {};
  std::vector<Section> sections = {};
  std::vector<Prop> props = {};
  std::vector<SurfaceLoad> loads = {};
  std::vector<StructureLoad> structure_loads = {};
  std::vector<Earthwork> earthworks = {}; ///< in the order in which they come
  /// Squares of particles are cut at the edges of regions even where there are no structures, since the model
  /// of another stage has some (plot.hpp).
  bool cut_at_edges = false;
  ContactNormals normals = ContactNormals::automatic;
  ContactGaps gaps = {}; ///< no key of a case: tests/cost/structures measures what other values would do
  Scheme scheme;
  Sides sides = Sides::free_field;
  /// The base moves as its free field does, whatever the soil does (rigid_base.hpp). It goes with periodic
  /// sides or a container.
  bool rigid_base = false;
  /// Sides whose scattered waves a matched layer takes up instead of dashpots, and its depth in cells.
  std::vector<Side> matched_sides;
  int layer_cells = 10;
  std::vector<SideSprings> springs; ///< one for each side that has some
  /// Ground below the base if it differs from the lowest soil of the model: the base's dashpots or matched
  /// layer represent it.
  std::optional<materials::Elasticity> below_base;
  /// Fields of one's own that particles carry besides those of the table.
  std::vector<ParticleFieldDescription> more_fields = {};
  /// v_ref at x (m) and a time (s), m/s: how the rock would move without soil (mass_damping/passes.hpp).
  std::function<Vector(double, double)> rock_motion = [](double, double) { return Vector{}; };
  /// While it rests, shaking is over and soil reconsolidates (materials::after_shaking).
  materials::SoilClock clock = {};
  int threads = 1;

  bool periodic() const { return sides == Sides::periodic; }
  /// Whether the left and right edges carry faces.
  bool has_side_faces() const { return sides == Sides::free_field || sides == Sides::periodic_springs; }
};

} // namespace tremolo::mpm_domain
