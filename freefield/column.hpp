#pragma once

#include <functional>
#include <span>

namespace tremolo::freefield {

/// Particle velocity of the incident (upgoing) wave at the level of the column's base, m/s: half of what the
/// outcrop of the half-space would show.
struct Velocity {
  double x = 0.0;
  double y = 0.0;
};
using IncidentVelocity = std::function<Velocity(double time)>;

/// The column at one depth and the present time. Stresses are the dynamic part, tension positive.
struct ColumnSample {
  double vx = 0.0, vy = 0.0;                             ///< particle velocity, m/s
  double sxx = 0.0, syy = 0.0, sxy = 0.0;                ///< stress, Pa
  double vx_rate = 0.0, vy_rate = 0.0;                   ///< time derivatives of velocity, m/s2
  double sxx_rate = 0.0, syy_rate = 0.0, sxy_rate = 0.0; ///< and of stress, Pa/s
};

/// A laterally uniform (1D) free field that is marched in time: what a source process asks of any column,
/// whatever its discretisation, integrator or soil law.
class Column {
public:
  virtual ~Column() = default;

  /// Advances by time_step(). An adaptive integrator takes as many steps inside as it needs.
  /// @throws std::runtime_error if the state is no longer finite
  virtual void step() = 0;

  /// Present time, s.
  virtual double time() const = 0;

  /// The constant interval between two states that can be sampled, s.
  virtual double time_step() const = 0;

  /// y of the lowest and the highest point that can be sampled, m.
  virtual double base_level() const = 0;
  virtual double surface_level() const = 0;

  /// The present state at the levels y (m), each within [base_level(), surface_level()].
  /// @throws std::invalid_argument for a level outside, or if the spans differ in size
  virtual void sample(std::span<const double> y, std::span<ColumnSample> samples) const = 0;

protected:
  Column() = default;
  Column(const Column&) = default;
  Column(Column&&) = default;
  Column& operator=(const Column&) = default;
  Column& operator=(Column&&) = default;
};

} // namespace tremolo::freefield
