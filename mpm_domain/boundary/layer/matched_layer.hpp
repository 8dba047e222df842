#pragma once

// A matched layer instead of the dashpots of Eq. (6). The free field enters as before, by its velocity and
// stress at the faces; the layer takes up the scattered field
//
//     w = v^m - v^ff,        f^b = sigma^ff n + t^st + t^layer,
//
// which is all that travels outwards. With w_j = sum_f H_jf w_f at the layer's nodes on the boundary, their
// inertia m_j and the forces F_j of the layer behind them,
//
//     t_f L_f = sum_j H_jf (F_j - m_j dw_j/dt),        H_jf = L_f N_jf / sum_f L_f N_jf,
//
// N_jf being the node's hat averaged along the face. The domain's own part of the inertia, m_j dv^m/dt, is
// lumped to the faces and from there to the grid, where it adds to the soil's mass; so the tie needs no
// spring.
//
// Where both a side and the base have a layer, a corner stretched in both directions joins them
// (layer_corner.hpp); where only one of them has, its layer ends in dashpots stretched like it.

#include "mpm_domain/boundary/layer/layer_joint.hpp"
#include "mpm_domain/boundary/layer/layer_lattice.hpp"
#include "mpm_domain/boundary/support.hpp"

#include <optional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

struct Ground;

/// A layer behind the faces of one side.
class MatchedLayer {
public:
  /// @param all faces of the domain
  /// @param side of the domain; the layer is spec.layer_cells cells deep and made of the soil at the faces
  /// @throws std::invalid_argument if the side has no faces or soil is missing between them
  MatchedLayer(const Ground& ground, std::span<const BoundaryFace> all, Side side);

  /// Takes the faces, and shares out the mass of the layer and of its corners to them.
  /// @param all faces of the domain
  void lump(std::span<BoundaryFace> all);

  /// Sets the motion of the layer's boundary nodes from the last time to this one.
  /// @param v_domain of half a step before it, or of the mean of the step before; free_field of this time;
  /// both of all faces of the domain
  void follow(std::span<const Vector> v_domain, std::span<const eq6::FreeField> free_field);
  /// Moves the layer to this time (s), its boundary as it follows.
  void advance(double time, WorkerPool& workers);
  /// The layer's traction on its faces, up to the inertia that the faces carry.
  void react(double time, std::span<const eq6::FreeField> free_field, std::span<SupportLoad> loads);

  /// Time since the last one, s; none at the first time.
  [[nodiscard]] std::optional<double> step_to(double time) const {
    return started_ ? std::optional(time - time_) : std::nullopt;
  }
  [[nodiscard]] Side side() const { return side_; }
  [[nodiscard]] LayerLattice& lattice() { return lattice_; }
  /// Velocity of the node at an end (0 or 1) of the boundary, m/s, along the boundary and its normal.
  [[nodiscard]] Vector end_velocity(std::size_t end) const {
    return end == 0 ? velocity_.front() : velocity_.back();
  }

  /// Adds all that changes with time, for a checkpoint.
  void add_state(SavedNumbers& state);

private:
  /// H of one face, which touches up to three consecutive nodes.
  struct Tie {
    std::vector<std::pair<std::size_t, double>> weights; ///< node, H_jf
    double length = 0.0;
    double mass = 0.0; ///< kg/m2
  };

  [[nodiscard]] Vector local(Vector v) const;

  Side side_;
  Vector along_, normal_;
  std::size_t first_ = 0;
  std::vector<Tie> ties_;
  LayerLattice lattice_;
  bool started_ = false;
  double time_ = 0.0;
  std::vector<Vector> v_free_;   ///< at the last time, per face, m/s
  std::vector<Vector> a_free_;   ///< half a step before it, m/s2
  std::vector<Vector> velocity_; ///< of the lattice's nodes on the boundary, m/s
};

/// The matched layers of a domain, joined where they meet at a corner.
class MatchedLayers final : public Support {
public:
  /// @throws std::invalid_argument as MatchedLayer does
  MatchedLayers(const Ground& ground, std::span<BoundaryFace> faces);

  std::string name() const override { return "matched layers"; }
  bool is_timed() const override { return true; }
  void exchange(const Exchange& at, std::span<SupportLoad> loads) override;
  void add_state(SavedNumbers& state) override;

private:
  /// Two layers and the corner between them.
  struct Corner {
    std::size_t side; ///< which of the layers
    std::size_t base;
    LayerJoint joint;
  };

  std::vector<MatchedLayer> layers_;
  std::vector<Corner> corners_;
};

} // namespace tremolo::mpm_domain
