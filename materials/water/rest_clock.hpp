#pragma once

namespace tremolo::materials {

/// The clock of the rest after shaking, in which soil and water consolidate and nothing moves fast. Water
/// flows N times as easily as it does in nature, so that time of the soil passes N times as fast as the time
/// t that is simulated. N rises from 1, since pressure rings where the resistance of the grains falls at
/// once:
///
///     N(t) = F^min(1, (t - t_0)/T_r),     time of the soil = t_0 + int N dt from t_0 to t
///
/// with the factor F that the case asks for. Before t_0 both times are one, and with F = 1 always.
struct RestClock {
  static constexpr double rise = 2.0; ///< T_r, s

  double from = 0.0;   ///< t_0, s
  double factor = 1.0; ///< F, 1, at least 1

  bool has_begun(double time) const { return time >= from; }
  /// N, 1
  double speed(double time) const;
  /// s; of a time that is simulated, s
  double time_of_soil(double time) const;
  /// The simulated time at which the soil has come to a time of its own, s.
  double simulated_time(double time_of_soil) const;
};

} // namespace tremolo::materials
