#pragma once

// Motion of the ground at the faces, and the nodes that they touch.
//
// Dashpots follow each face's clock, the slowest among its nodes: at a node of fine cells the damping of a
// whole coarse step would be past its limit.
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

#include "mpm_domain/boundary/boundary_faces.hpp"
#include "mpm_domain/boundary/near/near_faces.hpp"
#include "mpm_domain/passes/step.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// The velocity v- as dashpots use it after a step that ended with v+ (see above), m/s.
inline Vector without_residual(Vector before, Vector last_after) {
  return before - 0.5 * (last_after - before);
}

class FaceMotion {
public:
  FaceMotion() = default;
  explicit FaceMotion(std::size_t faces);

  /// After a sort: faces that are no longer worked out here touch no nodes.
  void forget_weights();
  /// At the first tick of a step: finds weights and clock of each face, and v^m for the exchange.
  /// @param near  the faces that are worked out here; velocities of others come from other ranks
  /// @param soil  by face; empty where the positions of dry particles are read
  void begin_step(Step& step, std::span<const BoundaryFace> faces, NearFaces& near,
                  std::span<const FaceSoil> soil);
  /// At a later tick: finds weights and v^m of the faces that are due.
  void go_on(Step& step, std::span<const BoundaryFace> faces, std::span<const FaceSoil> soil);
  /// After the update of the nodes, where there is water: what is right at the faces whose particles this
  /// rank has.
  void see_kick(const Grid& grid, const NearFaces& near);
  /// v+ of the last step by face, x and y (m/s); none without water and before the first step.
  std::span<double> kicks() { return kicked_; }

  /// By face, m/s: v^m as the dashpots used it at the last exchange, its mean over the ticks since the
  /// exchange before, and that mean of v- itself.
  std::span<const Vector> seen() const { return seen_; }
  std::span<const Vector> seen_mean() const { return seen_mean_; }
  std::span<const Vector> mean() const { return mean_; }
  /// v^m as dashpots see it at the start of a face's present step, m/s.
  Vector velocity(std::size_t face) const { return velocity_[face]; }
  /// W of a face's nodes, and its clock, as of then.
  std::span<const FaceWeights> weights() const { return weights_; }
  int clock(std::size_t face) const { return clock_[face]; }
  /// Whether a step of the face begins with this tick.
  bool is_due(const Ticks& ticks, std::size_t face) const { return clock_[face] >= ticks.first_due(); }

  /// State that a checkpoint stores between steps (state.hpp).
  template <class Writer>
  void save(Writer& to) const {
    to.write("faces.step_sums", step_sums_);
    to.write("faces.kicked", kicked_);
  }
  template <class Reader>
  void restore(const Reader& from) {
    step_sums_ = numbers_of_size(from, "faces.step_sums", step_sums_.size());
    kicked_ = from.numbers("faces.kicked");
    if (!kicked_.empty())
      kicked_ = numbers_of_size(from, "faces.kicked", 2 * weights_.size());
  }

private:
  void weigh(Step& step, const BoundaryFace& face, std::size_t f, std::span<const FaceSoil> soil);
  void add_to_mean(std::size_t face, Vector v);
  Vector take_mean(std::size_t face);

  std::vector<FaceWeights> weights_;
  std::vector<int> clock_;
  std::vector<Vector> seen_, seen_mean_, mean_, velocity_;
  std::vector<double> kicked_;    ///< v+_x, v+_y of the last step where there is water, m/s; none: empty
  std::vector<double> step_sums_; ///< over ticks since the exchange: sum of w v_x, w v_y (m/s) and of w
};

} // namespace tremolo::mpm_domain
