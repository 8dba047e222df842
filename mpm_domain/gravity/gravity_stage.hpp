#pragma once

// The gravity stage finds stresses in equilibrium with the given geometry. Base nodes are fixed, side nodes
// may move vertically only. Particles keep their positions, as finite-element programs do when they reset
// displacements after a geostatic step, so the weights are constant and the velocity can stay on the grid:
//
//     m_i dv_i/dt = f_i - alpha m_i v_i,      alpha = 2 omega_1,      omega_1 = pi c_s / (2 H),
//
// where soil weighs what it weighs under water, water that seeps pulls at it (water/seepage_force.hpp), and
// its pore pressure stays that of the undisturbed water. It damps the slowest mode of a layer of depth H
// critically and every other at the same rate. It ends when the unbalanced force in the free directions,
// ||f|| over the norm of all nodal weights, is below the stated residual.
//
// Other static stages follow: loads on the surface and on structures, and construction, which places and
// removes soil and structures and changes the level of the water (construction.hpp). What they bring goes
// from 0 to its size along half of a cosine,
//
//     share(t) = (1 - cos(pi t/T))/2,      0 <= t <= T,
//
// while the ground is damped as above, and stays; then the stage goes on until all rests. Positions, and with
// them the weights, are kept here too, as in any analysis of small displacements; the way that the soil has
// gone, u = int v dt, counts as displacement from then on; that of a rigid structure is reported. Static
// stages are drained unless they say otherwise, for all soils or some: what an undrained one has done to the
// pore pressure is gone at the end of the next one in which the soil is drained.
//
// Structures stand in place, bonded to the soil. Once all rests, bonds become contact with friction, and the
// stage goes on until all rests again. Where it cannot, since a structure stands on a slope that is too
// steep for it, say, the bonded state is kept.

#include "mpm_domain/domain.hpp"
#include "mpm_domain/gravity/begin_history.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tremolo::mpm_domain {

/// Displacement and rotation of a rigid structure in the stages after gravity, or since it was placed.
struct StructureWay {
  std::string name;
  Vector way;        ///< of its centre, m
  double turn = 0.0; ///< rad, anticlockwise
};

/// Nodal reactions of the constraints at the end of the stage, N/m: what the supports exert on the soil.
struct Reactions {
  std::vector<std::size_t> base;  ///< nodes fixed in x and y
  std::vector<std::size_t> sides; ///< nodes fixed in x only
  std::vector<Vector> force;      ///< at those of the base, then at those of the sides
  bool slipping = false; ///< structures or linings do not rest on their friction: bonds stay until shaking
  std::vector<std::size_t> slipping_bodies; ///< those that do, as indices into Contact::bodies()
  std::vector<CutStress> cut;               ///< soils that cannot hold their stress
  std::vector<StructureWay> ways; ///< of rigid structures; none where there is no stage after gravity
  std::size_t particles = 0;      ///< of the whole domain
};

struct GravitySettings {
  double residual = 1e-9; ///< unbalanced over applied force
  double max_time = 60.0; ///< s of relaxation after which the stage gives up
  /// Unbalanced forces less deep than this below the surface do not count, in cells.
  double skin = 0.0;
  /// Time is not over yet, but doubled, up to three times, while the residual is below this share of what it
  /// was half-way, 1.
  double falling = 0.0;
};

/// The soils whose pore water moves with the grains in a stage.
struct UndrainedSoils {
  bool any = false;
  std::vector<std::string> names = {}; ///< none: all of them

  bool include(const std::string& soil) const {
    return any && (names.empty() || std::ranges::find(names, soil) != names.end());
  }
};

/// Settings of a stage after gravity.
struct StageSettings {
  double ramp = 0.0;      ///< T, s
  double residual = 1e-9; ///< as in GravitySettings
  double max_time = 60.0; ///< s of relaxation after the ramp
  UndrainedSoils undrained = {};
};

/// A stage in which a load comes onto the surface, or onto a structure.
struct LoadSettings : StageSettings {
  std::size_t load = 0; ///< index into Spec::loads, or into Spec::structure_loads
  bool on_structure = false;
};

/// A stage that changes what the model consists of: after the last of them it is what its Spec says.
struct ConstructionSettings : StageSettings {
  std::vector<Region> regions; ///< of the model until then
  std::vector<Structure> structures;
  std::optional<GroundWater> water;
  std::vector<Prop> props = {};
};

/// One of both. Its special members are compiled once.
class StaticStage : public std::variant<LoadSettings, ConstructionSettings> {
public:
  using variant::variant;
  using variant::operator=;
  StaticStage();
  StaticStage(const StaticStage& other);
  StaticStage(StaticStage&& other) noexcept;
  StaticStage& operator=(const StaticStage& other);
  StaticStage& operator=(StaticStage&& other) noexcept;
  ~StaticStage();
};

/// A stage has run out of time before all was at rest.
class NotAtRest : public std::runtime_error {
public:
  NotAtRest(const std::string& what, std::size_t stage_, std::shared_ptr<Domain> model_)
      : std::runtime_error(what), stage(stage_), model(std::move(model_)) {}

  std::size_t stage;             ///< 0 is gravity, the stages after it follow
  std::shared_ptr<Domain> model; ///< of that stage; null: that of the end
};

/// Reports how far the stage is, now and then and at its end: steps done, and the residual reached.
using GravityProgress = std::function<void(long step, double residual)>;

/// Reports how far a stage is, as GravityProgress does; stage 0 is gravity, the stages after it follow.
using StageProgress = std::function<void(std::size_t stage, long step, double residual)>;

/// Brings the domain to rest under gravity and the loads on its surface, all laws at peak strength (no
/// softening); plastic strains are reset after it.
/// @returns the reactions of the constraints
/// @throws NotAtRest if the residual is not reached. The domain is then as the relaxation has left it:
/// particles with their plastic strains, and nodes with the velocity with which they go on, vx_after and
/// vy_after.
Reactions relax_under_gravity(Domain& domain, const GravitySettings& settings,
                              const GravityProgress& progress);

/// Does what relax_under_gravity does, and then what the stages after it do, one after the other
/// (static_stages.hpp).
/// @param domain  the model after the last of them; without construction all of them happen to it
Reactions bring_to_rest(Domain& domain, const GravitySettings& settings, std::span<const StaticStage> then,
                        const StageProgress& progress);

/// After NotAtRest: gives the particles the velocity with which the nodes go on, so that they show where the
/// soil moves.
void take_velocities_of_nodes(Domain& domain);

} // namespace tremolo::mpm_domain
