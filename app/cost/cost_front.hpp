#pragma once

// Work against precision: which settings are not beaten, and what a wanted error would cost.
//
//   front        a rung is on it where no other has both a smaller (or equal) error and less (or equal) time
//   error        e(h) = C h^p                          least squares of ln e over ln h
//   work         u(h) = U h^-q  particle updates       least squares of ln u over ln h
//   CPU time     t(u) = t0 + t1 u,  t0 >= 0            least squares of relative deviations
//
// over the rungs of a family, which differ in cell size h alone.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::app {

/// A rung as measured.
struct CostPoint {
  std::string family; ///< its setting but for the cell size
  double size = 0.0;  ///< h, m
  double error = 0.0; ///< 1
  double cpu = 0.0;   ///< s, user and system, of all processes
  double work = 0.0;  ///< particle updates
};

/// Indices of the points on the Pareto front, by growing CPU time.
std::vector<std::size_t> pareto_front(std::span<const CostPoint> points);

/// Error and CPU time of a family as power laws of the cell size, fitted to its points.
struct CostFit {
  std::string family;
  std::size_t points = 0;
  double order = 0.0, constant = 0.0;   ///< p and C, m^-p
  double work_order = 0.0, work = 0.0;  ///< q and U
  double start = 0.0, per_update = 0.0; ///< t0 and t1, s
  double error_spread = 1.0;            ///< largest factor between an error and the fit
  double time_spread = 1.0;             ///< the same of CPU time
  double smallest = 0.0, largest = 0.0; ///< h of the points, m

  double error_at(double size) const;
  double cpu_at(double size) const;
};

/// Fits of all families with at least two different sizes, in the order of their first points. A point
/// without error (the reference itself) has no logarithm and is left out.
std::vector<CostFit> fits(std::span<const CostPoint> points);

/// The largest cell size (m) at which the fit expects at most `target`, not above the largest measured one.
/// @returns nothing if the errors do not fall with the size, or where it lies below a quarter of the
/// smallest measured size: farther than a fit can see
std::optional<double> size_for(const CostFit& fit, double target);

} // namespace tremolo::app
