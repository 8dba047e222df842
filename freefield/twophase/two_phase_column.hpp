#pragma once

#include "freefield/column.hpp"
#include "freefield/fe/column_mesh.hpp"
#include "freefield/fe/fe_soil.hpp"
#include "freefield/profile.hpp"
#include "freefield/twophase/node_kick.hpp"
#include "freefield/twophase/wet_grid.hpp"
#include "freefield/twophase/wet_snapshot.hpp"

#include <array>
#include <functional>
#include <vector>

namespace tremolo::freefield {

struct TwoPhaseSettings {
  double max_element_size = 0.0; ///< m; every layer is cut into equal elements no longer than this
  double time_step = 0.0;        ///< s
  Damping damping;               ///< read only where a layer has a damping ratio
  double start_time = 0.0;       ///< s; the column is at rest then
  BaseKind base = BaseKind::compliant;
  /// Stress that loads the surface from the start, tension positive, Pa, of time; nothing loads it without.
  std::function<double(double time)> surface_load = {};
  /// Excess pore pressure kept at a sealed base from below, Pa, of time: water then enters there.
  std::function<double(double time)> base_pressure = {};
};

/// Finite-element column of soil and the water in it: solid and fluid have velocities of their own, stress is
/// effective stress and pore pressure, and every law of soil can follow it. Laterally periodic. Starts under
/// its own weight with hydrostatic pore pressure; the surface is free and drained, the base impervious.
/// Strains are small; porosity and permeability stay as they are. The equations stand in the source.
class TwoPhaseColumn final : public Column {
public:
  /// @throws std::invalid_argument for values outside their range, for a step over the stability limit (the
  ///         message states the limit), and for an initial stress beyond the soil's strength
  TwoPhaseColumn(const Profile& profile, const TwoPhaseSettings& settings, InputVelocity input);

  /// @throws std::runtime_error if the motion is no longer finite, or if the soil has become so stiff that
  /// the
  ///         step is no longer stable
  void step() override;
  double time() const override;
  double time_step() const override { return settings_.time_step; }
  double base_level() const override { return mesh_.node_y.front(); }
  double surface_level() const override { return mesh_.node_y.back(); }
  void sample(std::span<const double> y, std::span<ColumnSample> samples) const override;
  std::string report() const override;

  /// Darcy flux n w at the nodes from the base up, upwards, m/s.
  const std::vector<double>& flux() const { return snapshots_[0].flux; }

private:
  void strain_soil();
  void press_water();
  void kick();
  Phases kick_x(std::size_t node, double force) const;
  Phases kick_y(std::size_t node, const NodeForce& force) const;
  void remember(const std::vector<std::array<Phases, 2>>& before);
  void check_step();

  TwoPhaseSettings settings_;
  ColumnMesh mesh_;
  WetGrid grid_;
  FeSoil soil_;
  InputVelocity input_;
  SoilState state_;
  std::vector<WetSnapshot::Vector> u_;        ///< of the solid, m
  std::vector<std::array<Phases, 2>> v_;      ///< x and y, half a step ahead, m/s
  std::vector<std::array<Phases, 2>> before_; ///< a step ago
  std::vector<double> excess_;                ///< pore pressure at the centres, below cavitation too, Pa
  std::vector<double> deyy_, dgxy_;           ///< strain of the step
  std::vector<double> modulus_;               ///< M at the present stress, Pa
  std::vector<double> shear_, vertical_, pressure_; ///< at the centres, damping included, Pa
  std::array<WetSnapshot, 3> snapshots_;            ///< now, one and two steps ago
  long steps_ = 0;
  bool damped_ = false;
};

/// The largest stable step of the column for this profile before it moves, s.
/// @param growth  by how much moduli of the skeleton may grow
double two_phase_step_limit(const Profile& profile, double max_element_size, const Damping& damping,
                            double growth = 1.0);

} // namespace tremolo::freefield
