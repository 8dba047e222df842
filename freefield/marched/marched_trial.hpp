#pragma once

#include "freefield/marched/element_strain.hpp"
#include "freefield/marched/marched_state.hpp"
#include "freefield/marched/plane_factors.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::freefield {

/// One step on trial: from increments of stress the velocities of the nodes, from these the strain of the
/// elements, and from that what the laws and the water make of it. The step is the increment that comes back
/// unchanged.
class MarchedTrial {
public:
  MarchedTrial(const ColumnSoil& soil, const MarchedState& state);

  /// Begins a step from a state.
  /// @param moduli  M of each element, Pa, for strain that is owed to its law
  /// @param degraded  M of each element, Pa, for its small-strain damping; none without damping
  void begin(const MarchedScheme& scheme, const MarchedState& state, const BaseDrive& drive,
             const std::vector<double>& moduli, const std::vector<double>& degraded);

  /// Moves the nodes by increments of stress.
  void move(const MarchedScheme& scheme, const Increments& increment);

  /// Computes the increments of elastic soil under the present motion.
  void elastic_increment(Increments& made) const;

  /// Moves the nodes, lets the laws follow, and fills the residual: what the increments become, less the
  /// increments.
  void evaluate(const MarchedScheme& scheme, const MarchedState& state, const Increments& increment,
                Increments& residual);

  /// Moves the nodes by increments that the last evaluation has been corrected to. The laws are not called
  /// again: what the elements strain beyond that evaluation counts as elastic and is owed to their laws.
  void settle(const MarchedScheme& scheme, const MarchedState& state, const Increments& increment);

  /// The stress changes that the laws and the water give for the increments.
  Increments change() const { return stress_ - before_; }

  /// Finds the forces at the end of the step.
  void finish(const MarchedScheme& scheme);

  /// Makes a finished step the state.
  void accept(const MarchedScheme& scheme, MarchedState& state);

  NodeVelocity half(std::size_t node) const { return velocity(half_, node); }
  NodeVelocity whole(std::size_t node) const { return velocity(whole_, node); }
  ElementStrain strain(std::size_t element) const {
    const auto d = strain_.row(static_cast<Eigen::Index>(element));
    return {d[0], d[1], d[2], d[3]};
  }
  /// Stress at the end of the step, Pa, including relaxation mechanisms.
  ElementStress stress(std::size_t element) const {
    const auto s = stress_.row(static_cast<Eigen::Index>(element));
    return {s[0], s[1], s[2], s[3]};
  }
  /// Effective stress of an element at the end of the step without that of relaxation mechanisms, Pa.
  InPlane law_stress(std::size_t element) const {
    const auto s = law_stress_.row(static_cast<Eigen::Index>(element));
    return {s[0], s[1], s[2]};
  }
  /// Vertical stress (sxy, syy) of the small-strain damping of an element, Pa.
  Eigen::Vector2d viscous(std::size_t element) const {
    return viscous_.row(static_cast<Eigen::Index>(element)).transpose();
  }
  /// After finish(): F on a node, dashpots and incident wave included, and F~, Pa.
  Eigen::Vector2d force(std::size_t node) const {
    return force_.row(static_cast<Eigen::Index>(node)).head<2>().transpose();
  }
  double fluid_force(std::size_t node) const { return force_(static_cast<Eigen::Index>(node), 3); }
  /// F on the base node by stress and damping of its element alone, Pa.
  const Eigen::Vector2d& base_internal_force() const { return internal_force_; }
  /// m v + m_f w + s N(S) of the base node, kg/(m s).
  Eigen::Vector2d base_bracket() const;

private:
  void find_loads(const ElementFields& stress);
  void find_strain(const MarchedScheme& scheme);
  void find_stress(const MarchedState& state);
  void set_stiffness(Eigen::Index element, const MarchedState& state, double modulus);
  void add_driving_force();
  static NodeVelocity velocity(const NodeFields& fields, std::size_t node) {
    const auto v = fields.row(static_cast<Eigen::Index>(node));
    return {{v[0], v[1]}, {v[2], v[3]}};
  }

  using Pairs = Eigen::Array<double, Eigen::Dynamic, 2>;

  const ColumnSoil* soil_;
  SoilState soil_state_;
  BaseDrive drive_;
  Eigen::Matrix2d base_brake_ = Eigen::Matrix2d::Identity();
  Eigen::Vector2d internal_force_ = Eigen::Vector2d::Zero();
  bool damped_ = false;

  // Values at the nodes: G and R at both levels of a step without an increment, their split, and drag times
  // dt.
  NodeMasses masses_;
  NodeSplit half_split_, whole_split_;
  NodeFields half_given_, whole_given_;
  Pairs drag_; ///< kg/m2
  Eigen::ArrayXd porosity_;
  NodeFields velocity_;        ///< when the step begins, m/s
  NodeFields lateral_, force_; ///< s N, Pa s, and F, Pa
  NodeFields momenta_, half_, whole_;
  Pairs mean_; ///< velocity of both phases at the end of the step, m/s

  // Values in the elements: s h/2, 1 where water flows, dt/h, and the stiffness of the water, Pa.
  Eigen::ArrayXd share_, flowing_, per_length_, water_stiff_;
  // Elastic stiffness, Pa, of the laws, and with what relaxation mechanisms add over a step; what laws see of
  // the strain, and mechanisms take of the laws' stress.
  PlaneFactors of_law_, of_step_, seen_, taken_;
  PlaneFields kept_, faded_;            ///< what is left of the mechanisms' stress, and what goes, Pa
  PlaneFields law_before_, law_stress_; ///< when the step begins and ends, Pa
  PlaneFields scratch_;
  bool relaxes_ = false;
  Eigen::ArrayXd lowest_;         ///< excess pressure in a cavity, Pa
  Pairs viscosity_, viscous_;     ///< of damping, Pa s/m and Pa
  ElementFields before_, stress_; ///< when the step begins and ends
  Eigen::ArrayXd excess_;
  ElementFields strain_;          ///< of the step
  ElementFields followed_, owed_; ///< what the laws were last called with, and what they still owe
  std::vector<double> dexx_, deyy_, dgxy_;
};

} // namespace tremolo::freefield
