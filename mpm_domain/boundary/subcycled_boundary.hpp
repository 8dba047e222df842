#pragma once

// The boundary of a sub-cycled step. The exchange takes place once, at the first tick: the free field and
// what else makes up the tractions is held over the step. The dashpots of the soil's own velocity follow each
// face's clock, which is the slowest among its nodes,
//
//     t(tick) = t(exchange) + t_vis(v^m(tick)) - t_vis(v^m(exchange)),
//
// (at nodes that are faster than their face as an impulse at the start of its step, except for the static
// traction, which acts at every tick) since at a node of fine cells the damping of a whole coarse step would
// be past its limit.

#include "mpm_domain/step/subcycling.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

class SubcycledBoundary {
public:
  SubcycledBoundary(Domain& domain, const Subcycling& subcycling);

  /// What the exchange of the first tick has found, face by face.
  void hold(std::span<const Vector> velocities, std::span<const Vector> tractions);
  /// Adds the tractions of the faces that are due to the nodes' forces.
  void spread();
  /// Books the work of these, after the update.
  void book();

private:
  void weigh(std::size_t face);
  void spread_static();

  Domain& domain_;
  const Subcycling& subcycling_;
  std::vector<FaceWeights> weights_; ///< of the faces that are due; none of the others
  std::vector<FaceWeights> scaled_;  ///< by steps of the node's clock in one of the face's
  std::vector<FaceWeights> steady_;  ///< of all faces, as of the start of their present step
  std::vector<int> clock_;
  std::vector<Vector> v_exchange_, v_, v_mid_, exchanged_;
  std::vector<Vector> traction_;
  std::vector<Vector> moving_; ///< traction_ less the static one
};

} // namespace tremolo::mpm_domain
