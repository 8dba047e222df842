#pragma once

// A checked case: what a case file says, in SI units, after every rule has passed. The keys, their ranges and
// defaults stand in keys.cpp; docs/case-file.md is generated from there.

#include "materials/law/law.hpp"
#include "materials/relaxation/constant_damping.hpp"
#include "materials/water/soil_clock.hpp"
#include "motion/read/read.hpp"
#include "mpm_domain/spec/lattice.hpp"
#include "mpm_domain/spec/slices.hpp"
#include "scene/choices.hpp"
#include "scene/geometry.hpp"
#include "scene/random/random_profile.hpp"
#include "scene/soils/soil_profile.hpp"
#include "scene/structure.hpp"
#include "scene/text/errors.hpp"
#include "scene/water.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tremolo::scene {

/// [motion] pulse: the Ricker velocity pulse V (1 - 2a) exp(-a), a = (pi f (t - t0))^2.
struct RickerPulse {
  double frequency = 0.0; ///< f, Hz
  double time = 0.0;      ///< t0 of the peak, s
  double velocity = 0.0;  ///< V, m/s
};

/// [motion] file: a strong-motion record.
struct MotionFile {
  std::filesystem::path path; ///< absolute, or relative to the working directory
  motion::ReadAs as;          ///< what the case says of it
  double scale = 1.0;
};

using MotionSource = std::variant<RickerPulse, MotionFile>;

/// The motion of one shaking.
struct ShakingMotion {
  MotionSource source;
  std::size_t stage = 0;       ///< index into Case::timed
  double start = 0.0;          ///< simulated time at which the stage begins, t = 0 of the motion, s
  std::string path = "motion"; ///< of its table in messages, "stage[3].motion"
};

/// A record of [motion] or [stage.motion].
struct GivenRecord {
  const MotionFile* file;
  std::string path; ///< of its table
};

/// An incident plane wave. Its incident motion is along the polarisation, SV (cos, -sin) and P (sin, cos) of
/// the angle, at the reference point; scene::Motion evaluates it.
struct MotionInput {
  std::vector<ShakingMotion> shakings = {{}}; ///< of each stage in which the ground is shaken; at least one
  motion::MotionKind kind = motion::MotionKind::incident;
  Wave wave = Wave::sv;
  double angle_deg = 0.0; ///< from the vertical, travelling to +x, +y; in [0, 90)
  Point reference;
  std::string path = "motion"; ///< of its table in messages
};

/// Modulus reduction and damping against shear strain (engineering, 1).
struct StrainCurves {
  std::function<double(double)> modulus_reduction; ///< G/G0, in (0, 1]
  std::function<double(double)> damping;           ///< ratio of critical
  bool whole = false; ///< damping is all there is; otherwise the layer's own, at small strain, comes on top
};

/// The name that a soil's `curve` has for the built-in curves of Darendeli (2001).
inline constexpr std::string_view built_in_curve = "darendeli";

struct Soil {
  std::string name;
  materials::Law law;        ///< in the domain; eta already scaled to `softening_size`
  materials::Law column_law; ///< in columns: the same soil; hysteretic soil by the exact Masing rules
  /// Cell size for which the softening holds, m, where the soil has a reference_size.
  std::optional<double> softening_size;
  std::optional<StrainCurves> curves; ///< of hysteretic soils
  double damping = 0.0;               ///< ratio, of critical, at small strain, in the domain and in layers
  /// Set in a case with water: the law's density is then that of the saturated soil.
  std::optional<materials::PoreSpace> pores = std::nullopt;
  /// Void ratio that the law has by its own parameters, where it has one.
  std::optional<double> law_void_ratio = std::nullopt;
  /// Largest dynamic shear stress as the case gives it, Pa.
  std::optional<double> given_strength = std::nullopt;
};

struct Region {
  std::size_t soil = 0; ///< index into Case::soils; of a soil that is sliced its uppermost slice
  Polygon polygon;
  std::vector<double> cuts = {}; ///< y where the next slice of the soil begins, from the top down, m
  std::string name = {};         ///< by which stages call it; empty: they do not
  std::string path = {};         ///< of its table in messages, "region[1]"

  /// Index of the soil at a level (m) of the region.
  std::size_t soil_at(double y) const { return mpm_domain::soil_at(soil, cuts, y); }
};

/// The model during some of the stages.
struct Standing {
  std::vector<Region> regions;
  std::vector<Structure> structures;
  std::vector<Prop> props;
  std::optional<GroundWater> water;
};

/// A layer of a free-field profile.
struct Layer {
  double thickness = 0.0;          ///< m
  materials::Elasticity elastic;   ///< as waves meet it: below the water table of grains and water together
  double damping = 0.0;            ///< ratio, of critical
  std::optional<std::size_t> soil; ///< index into Case::soils; without one the layer is linear elastic
  bool wet = false;                ///< soil with pores below the water table, at which layers are cut
};

struct Damping {
  DampingModel model = DampingModel::none;
  double ratio = 0.0;                  ///< of soils and layers that have none of their own
  std::array<double, 2> frequencies{}; ///< Hz; of rayleigh
  /// Hz; of kelvin_voigt, kjartansson and constant, and where domain and columns have the ratio of hysteretic
  /// and shake, which there are none of in time.
  std::optional<double> reference_hz;
  materials::DampingBand band; ///< of constant
};

/// Numerics of the free-field models, one table each.
struct FeNumerics {
  double element_size = 0.0; ///< m
  std::optional<double> dt;  ///< s; otherwise the column chooses its own
};

struct OdeNumerics {
  OdeMethod method = OdeMethod::erk;
  double relative_tolerance = 0.0;
  double absolute_tolerance = 0.0; ///< of particle velocity, m/s; of strain, over the wave speed
  double cell_size = 0.0;          ///< m
};

struct EquivalentLinearNumerics {
  double sublayer = 0.0;     ///< layers of soil with curves are cut into equal ones no thicker than this, m
  double strain_ratio = 0.0; ///< effective over largest shear strain
  double tolerance = 0.0;    ///< relative change of modulus and damping
  int iterations = 0;        ///< at most
  bool allow_unconverged = false;
};

/// [[refine]]: where cells are 2^level times smaller than the mesh's.
struct Refinement {
  Box box;
  int level = 0;
};

struct Mesh {
  double size = 0.0;          ///< h, of the coarsest cells, m
  Box box;                    ///< the model; its left, right and lower edges carry boundary faces
  int particles_per_cell = 2; ///< per direction
  int layer_cells = 10;       ///< depth of matched layers behind the box, in cells
  std::vector<Refinement> refine;
  ParticleBoxes particle_boxes = ParticleBoxes::fixed;
  Dilatation dilatation = Dilatation::cell;
  Dispersion dispersion = Dispersion::plain;
  ContactNormals contact_normals = ContactNormals::automatic;

  /// Side of the square of a particle in the coarsest cells, m.
  double particle_size() const { return mpm_domain::particle_size(size, particles_per_cell); }
};

struct TimeStepping {
  double fraction = 0.5;    ///< of the critical step, in (0, 1]
  std::optional<double> dt; ///< a fixed step instead, s
  Transfer transfer = Transfer::apic;
  StepOrder order = StepOrder::musl;
  bool subcycle = false; ///< each level of the mesh takes a step of its own
};

/// Who computes a free field.
struct FreeFieldModel {
  SourceModel model = SourceModel::wave;
  std::filesystem::path file; ///< of recording: the recording; of external: the program
  std::optional<Side> side;   ///< of the recording of an exchange: whose free field

  bool operator==(const FreeFieldModel&) const = default;
};

/// Springs beside the dashpots of a side, as its keys say; scene/plan/boundary/springs.hpp has the rest.
struct SpringKeys {
  bool given_up = false;                          ///< dashpots alone
  std::optional<std::array<double, 2>> stiffness; ///< a_n, a_t; none: as the sides of the model ask for
  std::optional<Point> centre;                    ///< m
};

/// A lateral free field.
struct LateralBoundary {
  FreeFieldModel field;
  double surface = 0.0;           ///< y of its free surface, m
  double water_level = 0.0;       ///< y of its water table, m; only with Case::water
  std::vector<Layer> own_profile; ///< its own layers; empty: Case::profile
  Absorber absorber = Absorber::dashpots;
  SpringKeys springs;
};

struct BaseBoundary {
  FreeFieldModel field;
  BaseForm form = BaseForm::total;
  Absorber absorber = Absorber::dashpots;
  SpringKeys springs;
};

struct Boundary {
  Sides sides = Sides::free_field;
  LateralBoundary left; ///< of sides without free fields, the surface alone
  LateralBoundary right;
  BaseBoundary base;

  bool has_lateral_fields() const { return sides == Sides::free_field; }
  /// Whether one total field is that of the whole base.
  bool has_equal_sides() const {
    return left.surface == right.surface && left.own_profile.empty() && right.own_profile.empty();
  }
  /// Whether the model stands on ground, which free fields have too.
  bool has_ground_below() const { return base.field.model != SourceModel::shaking_table; }
  /// Whether the motion comes as waves of that ground, at an angle and after a while.
  bool takes_waves() const { return has_ground_below(); }
  /// Whether the base moves as [motion] says, whatever the soil does; the run is seen from it.
  bool base_is_rigid() const { return !has_ground_below(); }
};

/// [[stage]] kind = "gravity": base fixed, sides on rollers, damped relaxation to rest.
struct GravityStage {
  std::string name = "gravity";
  double acceleration = 9.81; ///< m/s2, downwards
  double residual = 1e-9;     ///< 2-norm of the unbalanced nodal forces over that of the nodal weights
  double max_time = 0.0;      ///< simulated time within which it must be reached, s
};

/// Settings common to all static stages after gravity.
struct StaticStage {
  std::string name;
  std::optional<double> ramp; ///< time in which the change grows, s; none: as slow as the ground asks for
  double residual = 1e-9;     ///< as of gravity
  double max_time = 0.0;      ///< simulated time after the ramp within which it must be reached, s
  bool undrained = false;     ///< pore water moves with the grains, of some soil at least
  /// Soil by soil, by name; other soils are then drained. Empty: `undrained` says it of all.
  std::map<std::string, StageDrainage> drainage;
  std::string path; ///< of its table in messages, "stage[1]"

  /// The soils that are undrained, where the stage says it soil by soil.
  std::vector<std::string> undrained_soils() const;
};

/// [[stage]] kind = "load": a load comes onto the surface of the ground, or onto a structure, and stays.
struct LoadStage : StaticStage {
  double x_min = 0.0; ///< where it begins and ends at the start, m
  double x_max = 0.0;
  double pressure = 0.0; ///< onto the surface, Pa
  double shear = 0.0;    ///< along it, towards +x, Pa
  std::string structure; ///< that it acts on; empty: it lies on the surface
  Point force;           ///< on the structure's centroid, N/m
  /// When a load begins that comes after a shaking and grows within `ramp` in the soil's own time, s of that
  /// time; none: it comes before the shaking, in a static stage.
  std::optional<double> start = std::nullopt;

  bool on_structure() const { return !structure.empty(); }
};

/// [[stage]] kind = "construction", soil, structures and props are placed and removed; or "water", which has
/// other levels.
struct ConstructionStage : StaticStage {
  std::vector<std::string> place;   ///< names of regions, structures and props
  std::vector<std::string> remove;  ///< likewise
  std::optional<GroundWater> water; ///< of kind "water": where it is from then on
  std::size_t loads_before = 0;     ///< how many of Case::loads come before it
  Standing before;                  ///< what stands until it
};

/// [[stage]] kind = "construction" after a shaking: soil is placed and removed while the ground goes on in
/// its own time.
struct Earthwork {
  std::string name;
  double start = 0.0;              ///< of the soil's time, s
  double ramp = 0.0;               ///< time in which the change grows, which is that of the stage, s
  std::vector<std::string> place;  ///< names of regions
  std::vector<std::string> remove; ///< likewise
  std::vector<Region> placed;      ///< these regions
  std::vector<Region> removed;     ///< likewise
  Standing after;                  ///< what stands from then on
  std::string path;                ///< of its table in messages, "stage[1]"
};

/// Settings of a rest besides its duration: sand reconsolidates with post-shaking properties
/// (materials::after_shaking).
struct Rest {
  double time_factor = 1.0;          ///< F of the soil's clock (materials/water/soil_clock.hpp)
  std::optional<double> until_ratio; ///< ends when no excess pore pressure ratio is larger, 1
  /// First interval of particle frames, of the soil's time, s; none: time_factor times that of the output.
  std::optional<double> every;
  double growth = 1.0;                 ///< of each interval of frames over the one before
  std::vector<double> times = {};      ///< of particle frames, rising, s after the start; empty: by intervals
  std::optional<double> history_every; ///< interval of histories, likewise
};

/// [[stage]] kind = "shaking", the motion enters, its t = 0 is the start of the stage; or "rest"; or a load
/// or a construction after a shaking, in which the soil rests.
struct TimedStage {
  std::string name;
  double start = 0.0;       ///< of the soil's time, which begins with the first shaking, s
  double duration = 0.0;    ///< s
  std::optional<Rest> rest; ///< absent: the ground is shaken
  std::string path;         ///< of its table in messages, "stage[1]"

  double end() const { return start + duration; }
};

struct Coupling {
  ExchangeMode mode = ExchangeMode::window;
  int window_steps = 0;           ///< steps of the source in one frame
  double connect_deadline = 0.0;  ///< s
  double step_deadline = 0.0;     ///< s
  double shutdown_deadline = 0.0; ///< s
};

/// [record]
struct Recording {
  bool exchange = false;
  OnFullDisk on_full_disk = OnFullDisk::stop;
};

/// [hosts.SIDE]: where the process that serves a side runs.
struct Host {
  StartBy start = StartBy::join;
  std::string address; ///< of ssh: "user@node2"
  std::string options; ///< of ssh or srun
  std::string command; ///< the `tremolo` there, as a shell there reads it
  std::string keys;    ///< folder of its CURVE keys there; empty: the same as here

  bool operator==(const Host&) const = default;
};

/// A machine beside that of the run on which ranks of the domain run.
struct RankMachine {
  std::string name;
  std::optional<int> most; ///< ranks that it takes; absent: as many as the machine of the run has processors
};

/// [hosts.domain]: where the ranks of the domain run, however many they are.
struct RankHosts {
  StartRanksBy start = StartRanksBy::ssh;
  std::vector<RankMachine> machines; ///< of ssh
  std::string options;               ///< of mpirun
};

/// [hosts]
struct Hosts {
  std::string endpoint;            ///< where processes on other machines reach the run
  std::string slurm_options;       ///< of the job that `tremolo sbatch` writes
  std::map<Side, Host> sides;      ///< those that are served from elsewhere; empty: all sources run here
  std::optional<RankHosts> domain; ///< absent: all ranks run here
};

/// [checkpoint]
struct Checkpoints {
  std::optional<int> every_steps; ///< of the domain; absent: by time
  double every_wall = 0.0;        ///< wall time, s
  int keep = 0;                   ///< 0: none are made
};

struct Monitor {
  std::string name;
  Point point;
  /// Index into Case::structures of the one that it moves with; otherwise it follows soil.
  std::optional<std::size_t> structure = std::nullopt;
};

/// Points along a straight line, whose histories are recorded as those of monitors.
struct Line {
  std::string name;
  Point from;
  Point to;
  double spacing = 0.0; ///< largest, m
};

/// Soil whose mean motion is recorded.
struct SlidingMass {
  std::string name;
  Outline outline;
};

struct Output {
  double every = 0.0;         ///< interval of particle frames, s
  double history_every = 0.0; ///< interval of monitors and energy, s
  std::vector<OutputField> fields;
};

/// A value that the case runs with, and where it was found.
struct ValueInForce {
  std::string key;    ///< "mesh.size", "soil.sand.density", "region[1].soil"
  std::string value;  ///< as TOML
  std::string origin; ///< "case.toml:14:9" or "default"
};

struct Case {
  std::string title;
  std::filesystem::path file;      ///< as given to load()
  std::filesystem::path directory; ///< that relative names in the case start from
  std::string text;                ///< the source

  MotionInput motion;
  std::optional<MotionInput> vertical; ///< the P wave of [motion.vertical], which adds to an SV wave
  double surface_level = 0.0;          ///< y of the free field's surface, m; none above a shaking table
  materials::Elasticity halfspace;     ///< none below a shaking table
  std::optional<GroundWater> water;    ///< while the ground is shaken
  std::vector<Soil> soils; ///< the slices of a soil stand one behind the other, and all have its name
  std::vector<SoilProfile> soil_profiles; ///< of the soils that are sliced
  std::vector<Region> regions;            ///< those that are there while the ground is shaken
  std::vector<Structure> structures;      ///< likewise
  std::vector<Lining> linings;
  std::vector<Section> sections;
  std::vector<Prop> props;        ///< those that stand while the ground is shaken
  double halfspace_damping = 0.0; ///< ratio, of critical
  std::vector<Layer> profile;     ///< from the surface down; empty: the half-space reaches the surface
  std::optional<RandomProfile> random_profile; ///< whose factors `profile` and the soils have
  Damping damping;
  FeNumerics fe;
  OdeNumerics ode;
  EquivalentLinearNumerics eql;
  Mesh mesh;
  TimeStepping time;
  Boundary boundary;
  std::optional<GravityStage> gravity; ///< absent: weightless, the model starts at rest without stress
  std::vector<LoadStage> loads;        ///< in the order in which they come, those after a shaking last
  std::vector<ConstructionStage> constructions; ///< likewise
  std::vector<Earthwork> earthworks;            ///< constructions after a shaking, in their order
  std::vector<TimedStage> timed;                ///< what happens in time, in its order, a shaking first
  Coupling coupling;
  Recording recording;
  Hosts hosts;
  Checkpoints checkpoints;
  std::vector<Monitor> monitors;
  std::vector<Line> lines;
  std::vector<SlidingMass> sliding_masses;
  Output output;
  double verify_tolerance = 0.0; ///< relative L2 error of particle velocity that `tremolo verify` allows

  std::vector<ValueInForce> values;
  std::vector<Finding> remarks; ///< warnings, then notes, of the rules that such a case goes by

  /// The incident plane waves, that of [motion] first; they point into this.
  std::vector<const MotionInput*> plane_waves() const;
  /// Whether one of them comes up at an angle.
  bool is_oblique() const;
  /// The records of all plane waves in all shakings; they point into this.
  std::vector<GivenRecord> records() const;
  /// The clock of the soil, which is shaken and rests.
  materials::SoilClock clock() const;
  /// The rest with the largest time factor; null without one: sand drains to the end as while it is shaken.
  const TimedStage* fastest_rest() const;
  /// The rest that follows a shaking at once; null where none does.
  const TimedStage* rest_after(const ShakingMotion& shaking) const;
  /// Time of the soil when the last stage ends, s after the first shaking has begun.
  double end_of_soil_time() const { return timed.empty() ? 0.0 : timed.back().end(); }
  /// The simulated time then, s.
  double end() const { return clock().simulated_time(end_of_soil_time()); }
};

/// Reads and checks a case file.
/// @throws CaseErrors (scene/text/errors.hpp) with every error of the file
Case load(const std::filesystem::path& file);

/// Reads a case from text. `file` names it in messages; relative file names start from `directory`.
Case parse(std::string_view text, const std::filesystem::path& file, const std::filesystem::path& directory);

/// The free field alone, by a model: a case of which only motion, surface level, half-space, water, soils,
/// profile, damping, gravity, mesh and time stepping are filled. Their tables are read and checked as by
/// load(), with this model on both sides; others may be missing and are not looked at, and so may [mesh].
/// @throws CaseErrors with every error of these tables
Case load_free_field(const std::filesystem::path& file, SourceModel model);

/// Reads the same tables from a text, as parse() does a whole case.
Case parse_free_field(std::string_view text, const std::filesystem::path& file,
                      const std::filesystem::path& directory, SourceModel model);

} // namespace tremolo::scene
