#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace tremolo::freefield {

/// Coupling of a column to the half-space below it, which determines the kind of its input motion.
enum class BaseKind {
  compliant, ///< elastic half-space: takes the incident (upgoing) wave at the base, half the outcrop motion
  rigid      ///< the motion at the base is prescribed: takes the within (borehole) motion, whole
};

/// Particle velocity, m/s.
struct Velocity {
  double x = 0.0;
  double y = 0.0;
};

/// The input motion at the level of the column's base: the velocity of the incident wave under a compliant
/// base, that of the base itself if rigid. Zero before the column's start.
using InputVelocity = std::function<Velocity(double time)>;

/// The column at one depth and the present time. Stresses are the dynamic part, tension positive, total where
/// there is pore water.
struct ColumnSample {
  double vx = 0.0, vy = 0.0;                             ///< velocity of grains and water, m/s
  double sxx = 0.0, syy = 0.0, sxy = 0.0;                ///< stress, Pa
  double vx_rate = 0.0, vy_rate = 0.0;                   ///< time derivatives of velocity, m/s2
  double sxx_rate = 0.0, syy_rate = 0.0, sxy_rate = 0.0; ///< and of stress, Pa/s
  double ux = 0.0, uy = 0.0;                             ///< displacement since the start, m
  double eyy = 0.0, gxy = 0.0;                           ///< strain: duy/dy, dux/dy (engineering)
  double pore_pressure = 0.0;                            ///< excess over the hydrostatic one, Pa
};

/// Whether entry i of the requested levels y means the limit from below. sxx and the strains jump at a layer
/// interface: a level listed twice in a row means the limit from below and then from above, a level listed
/// once means that from above.
inline bool from_below(std::span<const double> y, std::size_t i) {
  return i + 1 < y.size() && y[i] == y[i + 1];
}

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

  /// The present state at the levels y (m), each within [base_level(), surface_level()]; at an interface the
  /// limit from below or above as from_below() says.
  /// @throws std::invalid_argument for a level outside, or if the spans differ in size
  virtual void sample(std::span<const double> y, std::span<ColumnSample> samples) const = 0;

  /// A text on the integrator's work so far; empty if there is nothing to report.
  virtual std::string report() const { return {}; }

protected:
  Column() = default;
  Column(const Column&) = default;
  Column(Column&&) = default;
  Column& operator=(const Column&) = default;
  Column& operator=(Column&&) = default;
};

} // namespace tremolo::freefield
