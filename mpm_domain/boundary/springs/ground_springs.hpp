#pragma once

// Springs beside the dashpots of Eq. (6): the ground beyond a face holds what comes to bear on it after the
// model was at rest,
//
//     f^spr = -k_n (d.n) n - k_t (d.t) t,      d = u^m - u^ff,      k_n = a_n G/R,  k_t = a_t G/R,
//
// with G of the ground that the face's impedance stands for and R the face's distance at the start from a
// centre, two cells at least (viscous-spring boundary: Deeks and Randolph 1994; Liu et al. 2006). d is
// zero at rest, where f^st holds the model. From one exchange to the next
//
//     d_n = d_(n-1) + dt [v_n - (v^ff_(n-1) + v^ff_n)/2]
//
// with the velocity v before the update at the face, which belongs to t_(n-1/2): particles do not follow all
// of a kick of the nodes, and v after the update would let the face sink for ever. Where water flows, v is
// that of grains and water together, as v^ff is.
//
// Under a base between two different free fields d is not zero even where nothing is scattered. A spring
// behind a lag holds, and lets waves pass,
//
//     s' = (d - s)/tau,      f^spr = -k s,      tau = rho c/k,
//
// in each direction; with tau <= rho c/k it only takes up energy at every frequency.

#include "mpm_domain/boundary/support.hpp"

namespace tremolo::mpm_domain {

/// The springs of a face.
struct FaceSprings {
  std::size_t face = 0;
  std::size_t field = 0; ///< index of their free field
  double length = 0.0;   ///< of the face, m
  Vector stiffness;      ///< k by direction, Pa/m
  bool lags = false;
  Vector rate;           ///< 1/tau, 1/s; of springs that lag
  Vector moved;          ///< d, m
  Vector strained;       ///< s, or d without a lag, m
  Vector field_velocity; ///< v^ff at the last time, m/s

  /// f^spr, Pa.
  Vector traction() const { return {-stiffness.x * strained.x, -stiffness.y * strained.y}; }
};

class GroundSprings final : public Support {
public:
  /// Puts the spec's springs beside the dashpots that faces have.
  GroundSprings(const Ground& ground, std::span<BoundaryFace> faces);

  std::string name() const override { return "ground springs"; }
  bool is_by_face() const override { return true; }
  void exchange(const Exchange& at, std::span<SupportLoad> loads) override;
  /// All of it is stored but for what a lag dissipates.
  double work() const override { return work_; }
  void add_state(SavedNumbers& state) override;

  /// The springs of a face; null where it has none.
  const FaceSprings* at(std::size_t face) const;

private:
  std::vector<FaceSprings> springs_; ///< by rising face
  double work_ = 0.0;                ///< J/m
  bool started_ = false;
  double time_ = 0.0; ///< s
};

} // namespace tremolo::mpm_domain
