#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace tremolo::materials {

/// The clock of soil that is shaken and rests in turn. In a rest, soil and water consolidate and nothing
/// moves fast. Water then flows N times as easily as it does in nature, so that time of the soil passes N
/// times as fast as the time t that is simulated. In a rest from t_0 to t_1,
///
///     N(t) = F^min(1, (t - t_0)/T_r, (t_1 - t)/T_r),     time of the soil = that at t_0 + int N dt from t_0
///     to t
///
/// with the factor F that the case asks for: pressure rings where the resistance of the grains changes at
/// once. The last stage does not slow down; a rest too short for both ramps turns back before N is F. While
/// the ground is shaken N = 1. Both times begin at 0.
class SoilClock {
public:
  static constexpr double rise = 2.0; ///< T_r, s

  struct Stage {
    double duration = 0.0;             ///< of the soil's time, s, > 0
    std::optional<double> factor = {}; ///< F of a rest, 1, at least 1; none: the ground is shaken
  };

  /// A clock without rests.
  SoilClock() = default;
  explicit SoilClock(const std::vector<Stage>& stages);

  /// Whether the soil rests at a simulated time (s), and whether it has begun to at that time or before.
  bool rests(double time) const;
  bool has_rested(double time) const { return !rests_.empty() && time >= rests_.front().from; }
  /// N, 1; at a simulated time, s.
  double speed(double time) const;
  /// s; of a time that is simulated, s
  double time_of_soil(double time) const;
  /// The simulated time at which the soil's own clock shows a given time, s.
  double simulated_time(double time_of_soil) const;

private:
  struct Rest {
    double from = 0.0;                                        ///< t_0, s
    double to = std::numeric_limits<double>::infinity();      ///< t_1, s
    double soil_from = 0.0;                                   ///< time of the soil at t_0, s
    double soil_to = std::numeric_limits<double>::infinity(); ///< and at t_1, s
    double factor = 1.0;                                      ///< F, 1
    double change = rise;                                     ///< how long N rises, and falls, s

    double rate() const; ///< d(ln N)/dt while N rises, 1/s
    double speed(double time_from_an_end) const;
    double time_of_soil(double time) const;
    double simulated_time(double time_of_soil) const;
    /// It ends after a time of the soil (s), since another stage follows.
    void end_after(double duration);
  };

  std::vector<Rest> rests_;
};

} // namespace tremolo::materials
