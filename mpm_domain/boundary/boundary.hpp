#pragma once

// The boundary of the domain: its faces, what stands behind them, and Eq. (6),
//
//     f^b = f^vis + f^dyn + f^st,
//
// whose parts it works out, spreads over the nodes and books, with the springs f^spr that stand beside the
// dashpots (ground_springs.hpp). Nobody else keeps a copy of any of this.
//
// The free field is exchanged once a step, at its first tick, and held over it. Dashpots follow each face's
// clock, the slowest among its nodes: at a node of fine cells the damping of a whole coarse step would be
// past its limit. A node faster than its face receives the moving part of the traction as an impulse at the
// start of the face's step, and the static part, like the weight of the soil that it holds, at every tick of
// its own. Matched layers step with clock 0 and give their nodes impulses at its ticks; their mass moves with
// the nodes at every tick.
//
// Particles do not follow all of a kick of the nodes: at rest on nodes that hardly touch soil they keep
// still, while forces that they do not feel kick the nodes by dt a in every step. What the next transfer
// takes away of v+ at a face, v+ - v-, is that residual. The implicit half of the dashpots, -C dt a/2, would
// carry it, and ground that settles for minutes would sink at dt a/2. Where there is water, dashpots
// therefore see
//
//     v- - (v+ of the last step - v-)/2,
//
// which differs from v- by less than the transfer takes off a wave. Springs never see a kick: they move with
// v-, of grains and water together as the free field that they move against, and the ledger books what they
// take up then, and as transfer what the kicks add to it. Springs between the grains and a free field of both
// would hold up ground that settles while its water rises.
//
// Where there is pore water, which knows one clock, sides lean with their soil (lean/leaning_sides.hpp), and
// are as high as it.

#include "mpm_domain/boundary/boundary_faces.hpp"
#include "mpm_domain/boundary/boundary_share.hpp"
#include "mpm_domain/boundary/closing_elements.hpp"
#include "mpm_domain/boundary/consistent_dashpots.hpp"
#include "mpm_domain/boundary/ground_springs.hpp"
#include "mpm_domain/boundary/layer/matched_layer.hpp"
#include "mpm_domain/boundary/lean/leaning_sides.hpp"
#include "mpm_domain/boundary/periodic_springs.hpp"
#include "mpm_domain/boundary/rigid_base.hpp"
#include "mpm_domain/fields/node_fields.hpp"
#include "mpm_domain/ranks/exact_sum.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

class ClockNodes;
class Ticks;

/// Gives every face the free field of a time (s) in which the domain's velocities there are v (m/s). Called
/// once a step; faces that a spring ties to the opposite side are left as they are. Behind the faces' own
/// stand the fields that springs have to themselves (GroundSprings::more_fields()).
using FreeFieldSource =
    std::function<void(long step, double time, std::span<const Vector> v, std::span<eq6::FreeField> field)>;

/// Work of the boundary in an update, J/m.
struct BoundaryWork {
  double held = 0.0; ///< of the static part
  double dashpots = 0.0;
  double springs = 0.0; ///< taken up by the springs as v- has moved
  double input = 0.0;
  double transfer = 0.0; ///< that, less what the springs have taken up on the nodes

  BoundaryWork& operator+=(const BoundaryWork& more) {
    held += more.held;
    dashpots += more.dashpots;
    springs += more.springs;
    input += more.input;
    transfer += more.transfer;
    return *this;
  }
};

/// What dashpots see of v- after a step that ended with v+ (see above), m/s.
inline Vector without_residual(Vector before, Vector last_after) {
  return {before.x - 0.5 * (last_after.x - before.x), before.y - 0.5 * (last_after.y - before.y)};
}

class Boundary {
public:
  std::span<const BoundaryFace> faces() const { return faces_; }
  std::span<BoundaryFace> faces() { return faces_; }
  /// Leaves the domain without faces: a free body.
  void remove_faces();

  /// Finds the faces along the edges of the model, before dashpots that match the soil in its present stress.
  void match(std::vector<Particles>& sets, const Spec& spec);
  /// Impedances P and S (Pa s/m) and static traction (Pa) of each face, for a checkpoint.
  std::vector<double> rest_state() const;
  /// Stands for a gravity stage whose faces were these.
  /// @throws std::invalid_argument for those of another boundary
  void set_rest_state(std::span<const double> state);

  /// Puts what the spec wants behind the faces of a domain at rest: matched layers, springs. Does nothing
  /// when it has been done.
  void build_supports(const Ground& ground);
  bool has_layers() const { return !layers_.empty(); }
  /// Where the base moves as it is told; the faces then have no tractions.
  std::optional<RigidBase>& rigid_base() { return rigid_base_; }
  const std::optional<RigidBase>& rigid_base() const { return rigid_base_; }
  /// Motion of a rigid base half a step before the end of the step just made; at rest where there is none.
  BaseMotion base_motion() const { return rigid_base_ ? rigid_base_->motion() : BaseMotion{}; }

  /// After a sort: the grid may have grown, and particles of faces may have come to other cells.
  void follow_sort(const Ground& ground);

  /// Where ranks share the domain: the nodes that faces may touch until the next sort, whose sums each rank
  /// is told.
  std::span<const std::size_t> shared_nodes() const {
    return share_ ? share_->nodes() : std::span<const std::size_t>();
  }
  /// After a scatter: reads the soil at the faces. Ranks tell each other of it, and of the sums at the shared
  /// nodes.
  void read_soil(Ground& ground);
  /// By face, where there is pore water or where ranks share the domain; else empty.
  std::span<const FaceSoil> soil() const { return soil_; }

  /// The passes of a step. At its first tick: velocities of the faces and free field, then what matched
  /// layers make of it.
  void exchange(Ground& ground, const ClockNodes& nodes, const FreeFieldSource& source, long step,
                double time);
  void react(double time, WorkerPool& workers);
  /// At every tick: evaluates Eq. (6) at the faces that are due and adds it to the nodes' forces and
  /// dashpots.
  void apply(Ground& ground, const Ticks& ticks, const ClockNodes& nodes);
  /// After the update: the work of the boundary by its parts, the same on all ranks.
  BoundaryWork follow_update(Ground& ground, const Ticks& ticks, const ClockNodes& nodes);
  /// Takes off the power (W/m) of the boundary's forces on the difference between v+ and the remapped
  /// velocity, at the nodes of one clock that count on this rank.
  void take_off_remap_power(Ground& ground, const ClockNodes& nodes, int clock, ExactSum& power) const;

  /// What the last exchange found per face: v^m (m/s) and the free field.
  std::span<const Vector> velocities() const { return v_exchange_; }
  std::span<const eq6::FreeField> free_field() const { return std::span(free_field_).first(faces_.size()); }
  /// Springs beside the dashpots; null without any.
  const GroundSprings* ground_springs() const { return ground_springs_ ? &*ground_springs_ : nullptr; }
  /// Where there is pore water.
  const LeaningSides& lean() const { return lean_; }
  /// W of a face's nodes in its present step.
  std::span<const FaceWeight> weights(std::size_t face) const { return weights_[face]; }
  /// What the boundary exerts at a face as of the start of its last step, Pa.
  Vector traction(std::size_t face) const {
    const Vector eq6 = traction_[face].total();
    return {eq6.x + spring_[face].x + reaction_[face].x, eq6.y + spring_[face].y + reaction_[face].y};
  }

  /// What a checkpoint keeps between steps (state.hpp).
  template <class Writer>
  void save(Writer& to) const {
    std::vector<double> levels;
    for (const BoundaryFace& face : faces_)
      levels.push_back(face.level);
    to.write("faces.level", levels);
    to.write("faces.step_sums", step_sums_);
    to.write("faces.kicked", kicked());
    if (rigid_base_)
      to.write("rigid_base", rigid_base_->state());
    for (std::size_t l = 0; l < layers_.size(); ++l)
      to.write("layer" + std::to_string(l), layers_[l].state());
    for (std::size_t c = 0; c < corners_.size(); ++c)
      to.write("corner" + std::to_string(c), corners_[c].joint.state());
    if (closing_)
      to.write("closing", closing_->state());
    if (ground_springs_)
      to.write("ground_springs", ground_springs_->state());
  }
  /// Goes on from there.
  /// @throws std::invalid_argument for the state of another boundary
  template <class Reader>
  void restore(const Reader& from) {
    set_levels(from.numbers("faces.level"));
    set_step_sums(from.numbers("faces.step_sums"));
    set_kicked(from.numbers("faces.kicked"));
    if (rigid_base_)
      rigid_base_->set_state(from.numbers("rigid_base"));
    for (std::size_t l = 0; l < layers_.size(); ++l)
      layers_[l].restore(from.numbers("layer" + std::to_string(l)));
    for (std::size_t c = 0; c < corners_.size(); ++c)
      corners_[c].joint.restore(from.numbers("corner" + std::to_string(c)));
    if (closing_)
      closing_->restore(from.numbers("closing"));
    if (ground_springs_)
      ground_springs_->restore(from.numbers("ground_springs"));
  }

private:
  /// What a face gives to its nodes, before it is shared out by their weights.
  struct Load {
    Vector force;   ///< N/m
    Vector dashpot; ///< Pa s
  };

  void set_levels(const std::vector<double>& levels);
  void set_step_sums(const std::vector<double>& sums);
  std::vector<double> kicked() const;
  void set_kicked(const std::vector<double>& numbers);
  void resize();
  bool is_due(int first_due, std::size_t face) const;
  void weigh(const Ground& ground, const ClockNodes& nodes, std::size_t face, bool first_tick);
  void add_to_step_mean(std::size_t face, Vector v);
  Vector take_step_mean(std::size_t face);
  void evaluate(std::size_t face);
  void close(double time);
  void move_springs(double time);
  void book_springs(std::size_t face, double impulse, Vector v, BoundaryWork& work) const;
  void spread(Ground& ground, const Ticks& ticks, const ClockNodes& nodes);
  void find_loads(int clock, const Ticks& ticks);
  /// Work of faces [begin, end) in the last update.
  BoundaryWork work_of(std::size_t begin, std::size_t end, const Grid& grid, const Ticks& ticks,
                       const ClockNodes& nodes) const;
  void correct_dashpots(Ground& ground, const Ticks& ticks, const ClockNodes& nodes);

  std::vector<BoundaryFace> faces_;
  std::vector<MatchedLayer> layers_;
  std::vector<JoinedLayers> corners_; ///< between them
  std::optional<PeriodicSprings> springs_;
  std::optional<RigidBase> rigid_base_;
  std::optional<ClosingElements> closing_;
  std::optional<GroundSprings> ground_springs_;
  bool supported_ = false;
  std::optional<BoundaryShare> share_; ///< between ranks

  std::vector<FaceSoil> soil_;
  LeaningSides lean_;
  std::vector<FaceWeights> weights_; ///< as of the start of each face's present step
  std::vector<int> clock_;
  std::vector<eq6::FreeField> free_field_; ///< of the faces, and those that springs have to themselves
  std::vector<Vector> v_exchange_;         ///< at the exchange, m/s
  std::vector<Vector> v_kicked_; ///< v+ of the last step where there is water, m/s; empty before the first
  std::vector<Vector> v_;        ///< at the start of each face's present step, m/s
  std::vector<eq6::Traction> traction_; ///< Eq. (6) with it, Pa
  std::vector<Vector> reaction_;        ///< of layers and springs, Pa
  double springs_took_ = 0.0;           ///< from the last exchange to this one, J/m
  std::vector<Vector> spring_;          ///< f^spr, Pa
  std::vector<double> step_sums_; ///< per face over the ticks of a step: sum of w v_x, w v_y (m/s) and of w
  FaceNodes nodes_;
  std::vector<Load> loads_;                          ///< by face and clock
  NodeField on_nodes_x_, on_nodes_y_;                ///< forces of the boundary on the nodes, N/m
  std::vector<ConsistentDashpots> dashpots_;         ///< one a clock
  std::vector<std::vector<FaceWeights>> consistent_; ///< by clock: of the faces with nodes of it alone
};

} // namespace tremolo::mpm_domain
