#pragma once

// The absorber behind the faces with reduced dispersion, in place of the dashpots of Eq. (6). A wave that
// leaves the grid at a right angle, and sends nothing back, has at the nodes of the edge
//
//     f = -Z (1 - 0.208 (k h)^2) v,      Z = rho c,
//
// by the equations of the wide boxes and of sharpening in half space. A dashpot, f = -Z v, sends back half of
// the difference. A mass m on the face and behind it a spring K and a dashpot Z in line have, with s = i
// omega h/c,
//
//     f = -Z (b s + 1/(1 + b s)) v = -Z (1 + b^2 s^2 - ...) v,      m = b Z h/c,  K = Z c/(b h),  b^2 = 0.2,
//
// which leaves a reflection of third order. The mass is nearly that of half a cell and the spring that of
// half a cell: the grid goes on by as much before it ends. The element only takes energy from the soil. Its
// spring's force F belongs to the times of the stresses,
//
//     dF/dt = K (v - F/Z),      F+ - F = dt K (v - (F + F+)/(2 Z)).
//
// It moves relative to a velocity v* of the free field, -Z(s) (v - v*). Waves of the free field go along the
// sides, where v* = v^ff as with dashpots. They go through the base, into the model and out of it, and only
// those that come in pass as they should if the element follows them. There v* is their velocity,
//
//     v* = (v^ff + sigma^ff n/Z)/2,      f = -Z(s) (v - v*) + Z v*,
//
// which for dashpots, Z(s) = Z, is Eq. (6). The mass feels the rate of Z v*, extrapolated by half a step from
// the last two steps.

#include "mpm_domain/boundary/support.hpp"

namespace tremolo::mpm_domain {

/// One element behind each face that still has dashpots, in their place.
class ClosingElements final : public Support {
public:
  ClosingElements(const Ground& ground, std::span<BoundaryFace> faces);

  std::string name() const override { return "closing elements"; }
  void exchange(const Exchange& at, std::span<SupportLoad> loads) override;
  void add_state(SavedNumbers& state) override;

private:
  struct Element {
    std::size_t face = 0;
    Vector normal;
    bool across = false;  ///< the free field's waves go across the face, not along it
    Vector impedance;     ///< Z, Pa s/m
    Vector delay;         ///< b h/c, s
    Vector of_soil;       ///< -F of the soil's motion, Pa
    Vector of_free_field; ///< F of the free field's, Pa
    Vector load;          ///< Z v* at the last time, Pa
    Vector rate;          ///< its rate half a step before that, Pa/s
  };

  std::vector<Element> elements_;
  bool started_ = false;
  double time_ = 0.0; ///< s
};

} // namespace tremolo::mpm_domain
