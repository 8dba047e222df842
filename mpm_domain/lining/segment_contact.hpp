#pragma once

// The impulses between soil and a lining at all segments at once. With normals n from soil to lining and
// tangents t = (-n_y, n_x), the impulses j = N n + T t act on the lining, their opposites on the soil, and
// change the speed at which both close by G j,
//
//     G = B m^-1 B^T + H A^-1 H^T:
//
// the soil answers with its nodes' masses, the beam with its implicit step (beam/beam_step.hpp). Its masses
// alone would make it too soft, a rigid body too stiff. With c the speeds at which both would close without
// impulses, and g a gap,
//
//     N >= 0,        c_n - (G j)_n <= g/dt,        one of both as an equation,
//     |T| <= mu N + a,        c_t - (G j)_t = 0 below that bound, of the sense of T at it,
//
// a being adhesion times area times time. Pore water carries no friction: where there is any, N' = N - q
// takes the place of N in the bound (segment_water.hpp), and a segment stays tied while N > 0 or its water
// bears suction, q above what it can. Segments that are open count as closed in q. The sets of segments that
// are tied and that slip are found as for rigid bodies (contact/rigid_contact.hpp): by repeated solution
// until no set changes, else by Gauss-Seidel.

#include "mpm_domain/lining/water/segment_water.hpp"

#include <algorithm>
#include <span>

namespace tremolo::mpm_domain {

/// A segment between soil and lining: what binds it, and the impulses found.
struct SegmentContact {
  double friction = 0.0;    ///< mu
  double adhesion = 0.0;    ///< a, kg/s
  double least_water = 0.0; ///< what q may fall to while water holds both together, kg/s

  bool tied = true;                ///< in the normal direction
  int slip = 0;                    ///< sense of T where it slips; 0: it sticks
  double normal_impulse = 0.0;     ///< N, kg/s
  double tangential_impulse = 0.0; ///< T, kg/s
  double water_impulse = 0.0;      ///< q, kg/s

  double bound(double effective) const { return friction * std::max(0.0, effective) + adhesion; }
};

/// @param answer   G, row after row, in the order N, T of each segment, m/s for each kg/s
/// @param closing  c, with g/dt taken off, m/s
/// @param bonded   all segments stick, whatever they would bear
/// @param water    what it bears; none: the soil is dry
/// The sets of the segments are where the search begins.
/// @returns solutions that it took; 0: Gauss-Seidel
int solve_segments(std::span<const double> answer, std::span<const double> closing,
                   std::span<SegmentContact> segments, bool bonded = false, const SegmentWater& water = {});

} // namespace tremolo::mpm_domain
