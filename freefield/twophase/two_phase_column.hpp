#pragma once

#include "freefield/base_motion.hpp"
#include "freefield/column.hpp"
#include "freefield/column_mesh.hpp"
#include "freefield/column_relaxation.hpp"
#include "freefield/column_soil.hpp"
#include "freefield/profile.hpp"
#include "freefield/twophase/node_kick.hpp"
#include "freefield/twophase/wet_energy.hpp"
#include "freefield/twophase/wet_grid.hpp"
#include "freefield/twophase/wet_snapshot.hpp"
#include "materials/water/soil_clock.hpp"

#include <array>
#include <functional>
#include <vector>

namespace tremolo::freefield {

struct TwoPhaseSettings {
  double max_element_size = 0.0;   ///< m; every layer is cut into equal elements no longer than this
  double time_step = 0.0;          ///< s
  Damping damping;                 ///< read only where a layer has a damping ratio
  double start_time = 0.0;         ///< s; the column is at rest then
  materials::SoilClock clock = {}; ///< while it rests, shaking is over and soil reconsolidates
  BaseKind base = BaseKind::compliant;
  /// Stress that loads the surface from the start, tension positive, Pa, of time; nothing loads it without.
  std::function<double(double time)> surface_load = {};
  /// Excess pore pressure kept at a sealed base from below, Pa, of time: water then enters there.
  std::function<double(double time)> base_pressure = {};
};

/// Finite-element column of soil and the water in it: solid and fluid have velocities of their own, stress is
/// effective stress and pore pressure, and every law of soil can follow it. Laterally periodic. Starts under
/// its own weight with hydrostatic pore pressure; the surface is free and drained, the base impervious.
/// Elements change their length and porosity as they strain, and water that leaves stays above the ground;
/// rotations are small and the permeability is constant. The equations stand in the source.
class TwoPhaseColumn final : public Column {
public:
  /// @throws std::invalid_argument for values outside their range, for a step over the stability limit (the
  ///         message states the limit), and for an initial stress beyond the soil's strength
  TwoPhaseColumn(const Profile& profile, const TwoPhaseSettings& settings, InputVelocity input);

  /// @throws std::runtime_error if the motion is no longer finite, if the soil has become so stiff that the
  ///         step is no longer stable, or if a porosity leaves 0.01 to 0.95
  void step() override;
  double time() const override;
  double time_step() const override { return settings_.time_step; }
  double base_level() const override { return mesh_.node_y.front(); }
  double surface_level() const override { return mesh_.node_y.back(); }
  void sample(std::span<const double> y, std::span<ColumnSample> samples) const override;
  std::string report() const override;

  /// Darcy flux n w at the nodes from the base up, upwards, m/s.
  const std::vector<double>& flux() const { return snapshots_[0].flux; }
  /// Present porosity of an element, counted from the base.
  double porosity(std::size_t element) const { return grid_.elements[element].porosity(); }
  WetEnergy energy() const;

private:
  /// Rates of work at the nodes, W/m2.
  struct Power {
    double base = 0.0, load = 0.0, drag = 0.0, damping = 0.0;
  };

  void strain_soil();
  double step_limit() const;
  void press_water();
  void stretch();
  void kick();
  Phases kick_x(std::size_t node, double force) const;
  Phases kick_y(std::size_t node, const NodeForce& force) const;
  void remember();
  void count_strain(std::size_t element, double shear, double vertical);
  void count_power();
  Power power() const;
  double base_traction(std::size_t direction) const;

  TwoPhaseSettings settings_;
  ColumnMesh mesh_;
  Rise rise_;
  WetGrid grid_;
  ColumnSoil soil_;
  ColumnRelaxation relaxation_;
  InputVelocity input_;
  SoilState state_;
  std::vector<WetSnapshot::Vector> u_;        ///< of the solid, m
  std::vector<std::array<Phases, 2>> v_;      ///< x and y, half a step ahead, m/s
  std::vector<std::array<Phases, 2>> before_; ///< a step ago
  std::vector<double> excess_;                ///< pore pressure at the centres, below cavitation too, Pa
  std::vector<double> deyy_, dgxy_;           ///< strain of the step
  std::vector<double> seen_exx_, seen_eyy_, seen_gxy_;       ///< what the laws see of it
  std::vector<double> modulus_;                              ///< M at the present stress, Pa
  std::vector<double> degraded_;                             ///< M in the present state, of damping, Pa
  std::vector<double> shear_, vertical_, pressure_;          ///< at the centres, damping included, Pa
  std::vector<double> sxx_before_, syy_before_, sxy_before_; ///< of the soil a step ago, Pa
  std::vector<double> lengths_;                              ///< of the elements, m
  Velocity reference_;                                       ///< v_ref at the present time, m/s
  std::array<double, 2> base_force_{};                       ///< of the lowest element on the base node, Pa
  std::array<WetSnapshot, 3> snapshots_;                     ///< now, one and two steps ago
  WetEnergy spent_; ///< without the kinetic energy; elastic with plastic work
  Power power_;     ///< at the present time
  long steps_ = 0;
  bool damped_ = false;
};

/// The largest stable step of the column for this profile before it moves, s.
/// @param growth  by how much moduli of the skeleton may grow
double two_phase_step_limit(const Profile& profile, double max_element_size, const Damping& damping,
                            double growth = 1.0);

} // namespace tremolo::freefield
