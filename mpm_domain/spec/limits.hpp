#pragma once

// Limits of the step and measures of the grid that the domain and whoever plans one must agree on.

#include "mpm_domain/spec/numerics.hpp"

#include <cmath>

namespace tremolo::mpm_domain {

/// The critical time step times c_p/h.
///
/// 0.746 h/c_p is what two-dimensional uGIMP with two particles a cell and direction allows inside; dashpots
/// at a corner, taken centred with lumped damping, allow 0.65 (measured; tests/stability/mpm_domain).
inline constexpr double largest_courant_number = 0.65;

/// The share of the critical step that the order usl bears: in a free body with noise it grows above
/// (measured; tests/stability/mpm_domain).
inline constexpr double usl_share = 0.85;

/// The critical step of soil with viscous damping, s. The viscous stress takes the strain rate of half a step
/// before: of a mode of frequency w,
///
///     v+ = v- - dt (w^2 u + beta w^2 v-),   u+ = u + dt v+,
///
/// whose roots stay in the unit circle (Jury) if w^2 dt (dt + 2 beta) < 4. With xi = beta w/2 that is the
/// limit dt < 2/w (sqrt(1 + xi^2) - xi) of central differences with damping in proportion to stiffness
/// (Belytschko, Liu and Moran 2000, Nonlinear Finite Elements for Continua and Structures, sec. 6.2), here
/// with 2/w = `undamped`. The order usl bears a share of 2/w, whatever the damping; so that the same share of
/// the result is what it bears, the result is the limit for share 2/w over the share.
/// @param undamped      critical step without damping, s
/// @param damping_time  beta, s
/// @param share         of the critical step that the order bears, usl_share or 1
inline double damped_step(double undamped, double damping_time, double share) {
  if (damping_time == 0.0)
    return undamped;
  const double borne = share * undamped;
  return undamped * (borne / (std::hypot(borne, damping_time) + damping_time));
}

/// The share of the critical step that an order of the step bears.
constexpr double share_of(StepOrder order) {
  return order == StepOrder::usl ? usl_share : 1.0;
}

/// Cells of empty grid around the model, room for soil that moves out of its box.
inline constexpr int margin_cells = 6;

/// Layers of coarser cells that run on the clock of finer ones beside them.
inline constexpr int buffer_layers = 2;

/// Way of a particle on a graded mesh from one sort to the next, in finest cells. Particles that near to
/// other levels are weighed the general way: the less of them, the more often is sorted.
inline constexpr double across_margin = 0.25;

/// Way of a particle on a mesh of one level from one sort to the next, in cells.
inline constexpr double sort_cells = 0.9;

/// Way from one sort to the next with reduced dispersion, whose wide boxes begin up to a quarter of a cell
/// before others.
inline constexpr double sharp_sort_cells = 0.7;

} // namespace tremolo::mpm_domain
