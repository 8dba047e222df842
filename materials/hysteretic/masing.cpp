#include "materials/hysteretic/masing.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials {
namespace {

using masing::first_point;

/// A point of the stress-strain plane, stress in Pa.
struct Turn {
  double strain = 0.0;
  double stress = 0.0;
};

/// Number of the oldest points that are never merged.
constexpr std::size_t exact_points = masing_capacity - 2;

std::size_t count(MasingHistory history) {
  return static_cast<std::size_t>(history[masing::reversals]);
}

Turn turn(MasingHistory history, std::size_t i) {
  return {history[first_point + 2 * i], history[first_point + 2 * i + 1]};
}

/// The curve that a strain lies on: doubled from `origin`, or the backbone.
struct Curve {
  bool virgin = true;
  Turn origin;          ///< of a curve that is not virgin
  std::size_t kept = 0; ///< reversal points that stay open below the origin
  bool merged = false;  ///< points between the kept ones and the origin are forgotten
};

double stress_on(const Backbone& backbone, const Turn& origin, double strain) {
  return origin.stress + 2.0 * backbone.stress(0.5 * (strain - origin.strain));
}

/// The curve one is on when going on from the accepted strain.
Curve current(MasingHistory history) {
  const std::size_t n = count(history);
  if (n == 0)
    return {};
  return {false, turn(history, n - 1), n - 1, history[masing::merged] != 0.0};
}

/// The curve after turning back at the accepted strain.
Curve turned(MasingHistory history) {
  const std::size_t n = count(history);
  const Turn here = {history[masing::strain], history[masing::stress]};
  if (n == masing_capacity)
    return {false, here, exact_points, true};
  return {false, here, n, history[masing::merged] != 0.0};
}

/// Whether `strain` lies beyond the point where the curve joins that of an earlier loop, or the backbone.
bool leaves(const Backbone& backbone, MasingHistory history, const Curve& curve, double strain) {
  const double direction = strain > curve.origin.strain ? 1.0 : -1.0;
  const auto beyond = [&](double tip) { return direction * (strain - tip) > 0.0; };
  if (curve.kept == 0)
    return beyond(-curve.origin.strain);
  if (!curve.merged || curve.kept < exact_points)
    return beyond(turn(history, curve.kept - 1).strain);
  // The curves no longer meet at a stored point. They cross, because a doubled curve from inside a loop is
  // the steeper one and reaches the loop's boundary before the loop's tip.
  const std::size_t outer = curve.kept - 2;
  const std::size_t tip = curve.kept == exact_points ? outer + 1 : outer - 1;
  return beyond(turn(history, tip).strain) ||
         direction * (stress_on(backbone, curve.origin, strain) -
                      stress_on(backbone, turn(history, outer), strain)) >=
             0.0;
}

/// The curve that `strain` lies on when approached straight from the accepted strain.
Curve find_curve(const Backbone& backbone, MasingHistory history, double strain) {
  Curve curve = masing_reverses(history, strain) ? turned(history) : current(history);
  while (!curve.virgin && leaves(backbone, history, curve, strain)) {
    if (curve.kept < 2)
      return {};
    curve.kept -= 2;
    curve.origin = turn(history, curve.kept);
  }
  curve.merged = curve.merged && curve.kept >= exact_points;
  return curve;
}

/// F tau_M + (1 - F) G_m gamma and its derivative, from those of tau_M.
/// @param largest  gamma_m
ShearResponse reduced(const Backbone& backbone, const ShearResponse& masing, double strain, double largest) {
  const double share = backbone.loops.factor(backbone.reduction(largest));
  const double rest = (1.0 - share) * backbone.secant(largest);
  return {share * masing.stress + rest * strain, share * masing.tangent + rest};
}

/// Strain at which a curve's oldest open loop left the backbone.
double largest_strain(MasingHistory history, const Curve& curve) {
  return curve.kept == 0 ? curve.origin.strain : turn(history, 0).strain;
}

/// Response of the Masing rules on a curve.
ShearResponse response_on(const Backbone& backbone, const Curve& curve, double strain) {
  if (curve.virgin)
    return backbone.response(strain);
  const ShearResponse half = backbone.response(0.5 * (strain - curve.origin.strain));
  return {curve.origin.stress + 2.0 * half.stress, half.tangent};
}

} // namespace

bool masing_reverses(MasingHistory history, double strain) {
  const std::size_t n = count(history);
  const double here = history[masing::strain];
  const double came_from = n == 0 ? 0.0 : turn(history, n - 1).strain;
  return (strain - here) * (here - came_from) < 0.0;
}

double masing_stress(const Backbone& backbone, MasingHistory history, double strain) {
  if (backbone.loops.any())
    return masing_response(backbone, history, strain).stress;
  const Curve curve = find_curve(backbone, history, strain);
  return curve.virgin ? backbone.stress(strain) : stress_on(backbone, curve.origin, strain);
}

double masing_tangent(const Backbone& backbone, MasingHistory history, double strain) {
  return masing_response(backbone, history, strain).tangent;
}

ShearResponse masing_response(const Backbone& backbone, MasingHistory history, double strain) {
  const Curve curve = find_curve(backbone, history, strain);
  const ShearResponse masing = response_on(backbone, curve, strain);
  if (curve.virgin || !backbone.loops.any())
    return masing;
  return reduced(backbone, masing, strain, largest_strain(history, curve));
}

double accepted_stress(const Backbone& backbone, MasingHistory history) {
  const double masing = history[masing::stress];
  if (!backbone.loops.any() || count(history) == 0)
    return masing;
  return reduced(backbone, {masing, 0.0}, history[masing::strain], turn(history, 0).strain).stress;
}

void masing_commit(const Backbone& backbone, MutableMasingHistory history, double strain) {
  if (std::abs(strain - history[masing::strain]) < least_strain_change)
    return;
  const Curve curve = find_curve(backbone, history, strain);
  if (!curve.virgin) {
    if (masing_reverses(history, strain) && count(history) == masing_capacity)
      history[masing::merges] += 1.0;
    history[first_point + 2 * curve.kept] = curve.origin.strain;
    history[first_point + 2 * curve.kept + 1] = curve.origin.stress;
  }
  history[masing::stress] =
      curve.virgin ? backbone.stress(strain) : stress_on(backbone, curve.origin, strain);
  history[masing::strain] = strain;
  history[masing::reversals] = curve.virgin ? 0.0 : static_cast<double>(curve.kept + 1);
  history[masing::merged] = curve.merged ? 1.0 : 0.0;
}

} // namespace tremolo::materials
