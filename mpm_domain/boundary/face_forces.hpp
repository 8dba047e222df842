#pragma once

// Forces of the faces on their nodes, and the work of these forces. With t^vis, t^dyn and t^st of Eq. (6) and
// what supports add (support.hpp), a face of length l gives a node
//
//     f_i = l W_i (t^vis + t^dyn + t^spr + t^own + t^driven + t^st),      C_i = l W_i Z,
//
// each at ticks of its own. A node faster than its face receives the moving part of Eq. (6) as an impulse at
// the start of the face's step, and the static part, like the weight of the soil that it holds, at every tick
// of its own. Supports step with clock 0 and give their nodes impulses at its ticks, except that springs go
// with the moving part; the mass that moves with a face moves with the nodes at every tick.

#include "mpm_domain/boundary/consistent_dashpots.hpp"
#include "mpm_domain/boundary/face_motion.hpp"
#include "mpm_domain/boundary/lean/leaning_sides.hpp"
#include "mpm_domain/boundary/support.hpp"

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Work of the boundary in an update, J/m.
struct BoundaryWork {
  static constexpr std::size_t count = 5;
  static constexpr std::size_t of_dashpots = 1; ///< where `dashpots` stands among the numbers()
  static constexpr std::size_t of_input = 2;    ///< and `input`

  double held = 0.0; ///< of the static part
  double dashpots = 0.0;
  double input = 0.0;
  double transfer = 0.0; ///< what springs have taken up as v- has moved, less what they have on the nodes
  double springs = 0.0;  ///< taken up by the springs as v- has moved

  std::array<double, count> numbers() const { return {held, dashpots, input, transfer, springs}; }
  static BoundaryWork of(const std::array<double, count>& numbers) {
    return {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]};
  }
};

/// Tractions on the faces in their present steps, by face.
struct FaceLoads {
  std::span<const BoundaryFace> faces;
  const NearFaces& near; ///< those that are worked out here
  const FaceMotion& motion;
  std::span<const eq6::Traction> eq6;    ///< Pa
  std::span<const SupportLoad> supports; ///< none where none stand there
  const LeaningSides& lean;
};

class FaceForces {
public:
  FaceForces() = default;
  FaceForces(const FaceForces&) = delete; // dashpots know the nodes
  FaceForces& operator=(const FaceForces&) = delete;

  /// After a sort: the grid may have grown.
  void follow_sort(const Ground& ground);
  /// Adds what the faces that are due exert at a tick to the nodes' forces and dashpots.
  void add(Step& step, const FaceLoads& loads);
  /// Its work in the update that followed: what counts on this rank, as BoundaryWork::numbers().
  ExactSums<BoundaryWork::count> work(Step& step, const FaceLoads& loads) const;
  /// Takes off the power (W/m) of these forces on the difference between v+ and the remapped velocity, at the
  /// nodes of one clock that count on this rank.
  void take_off_remap_power(Step& step, int clock) const;

private:
  /// Load of a face on its nodes of one clock, before it is distributed by their weights.
  struct Load {
    Vector force;   ///< N/m
    Vector dashpot; ///< Pa s
  };

  void find(int clock, const Ticks& ticks, const FaceLoads& loads);
  void correct_dashpots(Step& step, const FaceLoads& loads);
  void find_rows(const Ground& ground);
  template <typename OfNode>
  ExactSum sum_over_nodes(Ground& ground, const OfNode& of_node) const;

  FaceNodes nodes_;
  static constexpr std::size_t not_found = std::numeric_limits<std::size_t>::max();
  std::size_t nodes_in_rows_ = not_found;            ///< how many there were when rows were found
  std::vector<std::span<const std::size_t>> rows_;   ///< those that count on this rank, by rows of tiles
  std::vector<Load> loads_;                          ///< by face and clock
  NodeField on_nodes_x_, on_nodes_y_;                ///< N/m
  std::vector<ConsistentDashpots> dashpots_;         ///< one a clock
  std::vector<std::vector<FaceWeights>> consistent_; ///< by clock: of the faces with nodes of it alone
};

} // namespace tremolo::mpm_domain
