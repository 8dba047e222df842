#pragma once

#include "freefield/marched/element_strain.hpp"
#include "freefield/marched/marched_state.hpp"

#include <vector>

namespace tremolo::freefield {

/// One step on trial: from increments of stress the velocities of the nodes, from these the strain of the
/// elements, and from that what the laws and the water make of it. The step is the increment that comes back
/// unchanged.
class MarchedTrial {
public:
  /// Values of an increment: effective sxx, syy, sxy and pore pressure, Pa.
  static constexpr std::size_t values = 4;

  MarchedTrial(const FeSoil& soil, const MarchedState& state);

  /// Begins a step from a state.
  /// @param moduli  M of each element for its small-strain damping, Pa
  void begin(const MarchedScheme& scheme, const MarchedState& state, const BaseDrive& drive,
             const std::vector<double>& moduli);

  /// Fills the residual: what the increments become, less the increments.
  /// @param increment  4 values an element, from the base up
  void evaluate(const MarchedScheme& scheme, const MarchedState& state, const std::vector<double>& increment,
                std::vector<double>& residual);

  /// Makes the last evaluation the state: stress is that of the laws.
  void accept(const MarchedScheme& scheme, MarchedState& state) const;

  const std::vector<NodeVelocity>& half() const { return half_; }
  const std::vector<NodeVelocity>& whole() const { return whole_; }
  const std::vector<ElementStrain>& strain() const { return strain_; }
  const std::vector<ElementStress>& stress() const { return stress_; } ///< at the end of the step
  const SoilState& soil() const { return soil_state_; }
  /// Vertical stress (sxy, syy) of the small-strain damping of an element, Pa.
  const std::vector<Eigen::Vector2d>& viscous() const { return viscous_; }
  /// At the end of the step: F on a node by stress and damping of its elements, and with what dashpots and
  /// incident wave bring, Pa.
  Eigen::Vector2d internal_force(const MarchedState& state, std::size_t node) const;
  Eigen::Vector2d total_force(const MarchedScheme& scheme, const MarchedState& state, std::size_t node) const;
  /// F~ on a node at the end of the step, Pa.
  double fluid_force(const MarchedState& state, std::size_t node) const {
    return end_load(state, node).fluid_force;
  }
  /// m v + m_f w + s N(S) of a node at the end of the step, kg/(m s).
  Eigen::Vector2d bracket(const MarchedScheme& scheme, const MarchedState& state, std::size_t node) const;

private:
  void find_velocities(const MarchedScheme& scheme, const MarchedState& state);
  void find_strain(const MarchedScheme& scheme, const MarchedState& state);
  Eigen::Vector2d viscous_force(std::size_t node) const;
  NodeLoad end_load(const MarchedState& state, std::size_t node, double slowness = 0.0) const;

  const FeSoil* soil_;
  BaseDrive drive_;
  SoilState soil_state_;
  std::vector<NodeLoad> before_, change_;
  std::vector<Eigen::Matrix2d> implicit_; ///< (1 + dt/2 D/m)^-1
  std::vector<NodeVelocity> half_, whole_;
  std::vector<Eigen::Vector2d> after_drag_; ///< R'
  std::vector<ElementStrain> strain_;
  std::vector<ElementStress> stress_;
  std::vector<double> excess_;
  std::vector<double> viscosity_; ///< beta M of each element, Pa s
  std::vector<Eigen::Vector2d> viscous_;
  std::vector<double> dexx_, deyy_, dgxy_;
};

} // namespace tremolo::freefield
