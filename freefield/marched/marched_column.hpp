#pragma once

#include "freefield/base_motion.hpp"
#include "freefield/column.hpp"
#include "freefield/column_mesh.hpp"
#include "freefield/column_soil.hpp"
#include "freefield/marched/base_impedance.hpp"
#include "freefield/marched/marched_iteration.hpp"
#include "freefield/marched/marched_snapshot.hpp"
#include "freefield/marched/marched_state.hpp"
#include "freefield/marched/marched_tangent.hpp"
#include "freefield/marched/marched_trial.hpp"
#include "freefield/profile.hpp"
#include "freefield/twophase/wet_energy.hpp"
#include "materials/water/soil_clock.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace tremolo::freefield {

struct MarchedSettings {
  double max_element_size = 0.0; ///< m; every layer is cut into equal elements no longer than this
  double time_step = 0.0;        ///< s
  double slowness_x = 0.0;       ///< s = sin(angle)/c of the incident wave, s/m, at least 0: it travels to +x
  Damping damping;               ///< read only where a layer has a damping ratio
  double start_time = 0.0;       ///< s; the column is at rest then
  materials::SoilClock clock = {};     ///< while it rests, shaking is over and soil reconsolidates
  BaseKind base = BaseKind::compliant; ///< a rigid base moves as v(t - s x)
  /// Largest residual at which a step's iteration ends, over the largest stress increment so far, in (0, 1].
  /// The error that remains is smaller by orders of magnitude (docs/free-fields/fe-column.md).
  double tolerance = 0.1;
};

/// Finite-element column of soil and the water in it under a wave that comes in at an angle: every field
/// depends on t - s x, s the horizontal slowness of the incident wave. It takes every law of soil, by the
/// law's full increment of strain in the plane. It starts under its own weight with hydrostatic pore
/// pressure; the surface is free and drained, the base impervious. Elements change their length and porosity
/// as they strain vertically. The equations stand in marched_trial.cpp. The shear strain of a sample is
/// dux/dy - s vy.
class MarchedColumn final : public Column {
public:
  /// @throws std::invalid_argument for values outside their range, for a wave that is critical in a layer,
  /// for a step over the stability limit (the message states the limit), and for an initial stress beyond the
  /// soil's strength
  MarchedColumn(const Profile& profile, const MarchedSettings& settings, InputVelocity input);

  /// @throws std::runtime_error if the motion is no longer finite, if the soil has become so stiff that the
  /// step is no
  ///         longer stable or the wave critical, or if a porosity leaves 0.01 to 0.95
  void step() override;
  double time() const override { return time_of(static_cast<double>(steps_)); }
  double time_step() const override { return settings_.time_step; }
  double base_level() const override { return mesh_.node_y.front(); }
  double surface_level() const override { return mesh_.node_y.back(); }
  void sample(std::span<const double> y, std::span<ColumnSample> samples) const override;
  std::string report() const override;

  /// Steps whose increments of stress did not converge, and the largest residual that such a step was left
  /// with, relative to the largest increment so far.
  long unconverged_steps() const { return iteration_.unconverged(); }
  double largest_residual() const { return iteration_.largest_residual(); }
  /// Calls of the laws a step.
  double evaluations_per_step() const;
  /// Kinetic energy contains what the brackets of the equations hold beside it (marched_energy.cpp).
  WetEnergy energy() const;

private:
  double time_of(double step) const { return settings_.start_time + step * settings_.time_step; }
  Eigen::Vector2d input(double time) const;
  BaseDrive drive_to_next() const;
  void stretch();
  void remember();
  void check();
  void count_work(const BaseDrive& drive);
  void count_base_work(const BaseDrive& drive);
  double kinetic_energy() const;

  MarchedSettings settings_;
  ColumnMesh mesh_;
  ColumnSoil soil_;
  InputVelocity input_;
  BaseImpedance base_;
  Rise rise_;
  BaseDrive drive_; ///< of the last step
  MarchedScheme scheme_;
  MarchedState state_;
  MarchedTrial trial_;
  MarchedTangent tangent_;
  MarchedIteration iteration_;
  std::vector<Eigen::Vector2d> u_; ///< of the grains, m
  std::vector<double> modulus_;    ///< M at the present stress, Pa
  std::vector<double> degraded_;   ///< M in the present state, of damping, Pa; none without damping
  long steps_ = 0;
  bool damped_ = false;
  /// State of the base node: its bracket now, one and two steps ago, kg/(m s), and the force of its element
  /// and the power of the half-space, as of the last step.
  std::array<Eigen::Vector2d, 3> base_bracket_{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(),
                                               Eigen::Vector2d::Zero()};
  Eigen::Vector2d base_force_ = Eigen::Vector2d::Zero();
  double base_power_ = 0.0;
  std::array<MarchedSnapshot, 3> snapshots_; ///< now, one and two steps ago
  WetEnergy spent_;                          ///< without the kinetic energy; elastic with plastic work
};

/// The largest stable step of the column for this profile before it moves, s.
/// @param growth  by how much moduli may grow of soil whose stiffness follows pressure
/// @throws std::invalid_argument if the wave is critical in a layer, or may become so
double marched_step_limit(const Profile& profile, double max_element_size, double slowness_x,
                          const Damping& damping, double growth = 1.0);

} // namespace tremolo::freefield
