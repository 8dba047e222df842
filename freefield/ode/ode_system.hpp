#pragma once

#include "freefield/column.hpp"
#include "freefield/ode/ode_soil.hpp"
#include "materials/relaxation/relaxation.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace tremolo::freefield {

struct OdeCell {
  double length = 0.0;                   ///< m
  double density = 0.0;                  ///< kg/m3
  double modulus = 0.0;                  ///< at small strain, Pa
  double alpha = 0.0;                    ///< mass-proportional damping, 1/s
  double beta = 0.0;                     ///< stiffness-proportional damping, s
  materials::Relaxation relaxation = {}; ///< constant damping
};

/// Base of the column: rho c of the half-space (Pa s/m), the input motion (m/s), and the reference velocity
/// of mass-proportional damping, v_ref of base_motion.hpp (m/s).
struct OdeBase {
  BaseKind kind = BaseKind::compliant;
  double impedance = 0.0;
  std::function<double(double)> velocity;
  std::function<double(double)> reference;
};

/// The ordinary differential equations of one polarisation, with the state
///     u_b, e_0, a_0, v_1, e_1, a_1, v_2, ... e_{n-1}, a_{n-1}, v_n:
/// displacement of the base (m), strains of the cells, what each of their relaxation mechanisms remembers of
/// it, and velocities of the nodes (m/s) from the base up. All cells have as many mechanisms as the one with
/// the most; those that are too many stand still.
class OdeSystem {
public:
  using State = std::span<const double>;
  using Derivative = std::span<double>;

  /// @param soil  the cells that are not linear elastic
  OdeSystem(std::vector<OdeCell> cells, OdeBase base, OdeSoil soil);

  std::size_t size() const { return stride_ * cells_.size() + 1; }
  std::size_t cells() const { return cells_.size(); }
  /// Half bandwidth of the Jacobian.
  long bandwidth() const { return static_cast<long>(stride_); }
  std::size_t strain_index(std::size_t cell) const { return 1 + stride_ * cell; }
  std::size_t memory_index(std::size_t cell, std::size_t mechanism) const {
    return strain_index(cell) + 1 + mechanism;
  }
  std::size_t velocity_index(std::size_t node) const { return stride_ * node; } ///< of a node above the base

  /// dy/dt, and its two parts: that of the elastic waves and that of the stiffness-proportional damping,
  /// which is linear in the velocities and depends on nothing else.
  void derivative(double time, State y, Derivative rate) const { march(time, y, rate, 1.0); }
  void wave_part(double time, State y, Derivative rate) const { march(time, y, rate, 0.0); }
  void damping_part(State y, Derivative rate) const;

  using Entry = std::function<void(std::size_t row, std::size_t column, double value)>;
  void jacobian(double time, State y,
                const Entry& entry) const; ///< of derivative(), its entries that are not 0
  void damping_jacobian(const Entry& entry) const;

  /// Takes a state into the history of the soil.
  void accept(double time, State y);

  /// Stress of a cell with its damping, Pa, and its time derivative, Pa/s, in a state with the derivative
  /// dy/dt.
  struct Stress {
    double value = 0.0;
    double rate = 0.0;
  };
  Stress stress(double time, State y, State y_rate, std::size_t cell) const;

  /// Velocity of a node, m/s, and acceleration, m/s2.
  struct Motion {
    double velocity = 0.0;
    double acceleration = 0.0;
  };
  Motion motion(double time, State y, State y_rate, std::size_t node) const;

  double input_velocity(double time) const { return base_.velocity(time); } ///< m/s
  double mass(std::size_t node) const { return mass_[node]; } ///< of a node above the base, kg/m2

private:
  void march(double time, State y, Derivative rate, double damping) const;
  bool is_nonlinear(std::size_t cell) const { return soil_index_[cell] < soil_.cells().size(); }
  /// The stress of the law alone, Pa.
  double soil_stress(double time, std::size_t cell, double strain, double strain_rate) const;
  /// The derivative of the law's stress by strain, Pa.
  double soil_tangent(double time, State y, std::size_t cell) const;
  /// The stress of law and mechanisms together, from that of the law, Pa.
  double stress_with(State y, std::size_t cell, double soil_stress) const;
  /// The rate of the stress of law and mechanisms together, Pa/s.
  double stress_rate(double time, State y, State y_rate, std::size_t cell) const;
  void remember(State y, std::size_t cell, double soil_stress, Derivative rate) const;
  double strain_rate(double time, State y, std::size_t cell) const;
  /// Stress of the lowest cell by its law; its strain rate depends on the base's velocity, and that on it.
  double lowest_soil_stress(double time, State y) const;
  double undamped_base_velocity(double time, double stress) const;
  double base_velocity(double time, State y, double stress) const;
  /// Damping stress per difference of velocities over the cell, Pa s/m; that of the lowest cell per
  /// difference from the undamped base velocity.
  double viscosity(std::size_t cell) const;
  double input_acceleration(double time) const;

  std::vector<OdeCell> cells_;
  std::size_t stride_ = 2; ///< variables from one node to the next
  OdeBase base_;
  OdeSoil soil_;
  std::vector<std::size_t> soil_index_; ///< of a cell in soil_, or their number
  std::vector<double> mass_, alpha_;    ///< of the nodes, kg/m2 and 1/s
  double base_ratio_ = 0.0; ///< r: viscosity of the lowest cell over the half-space's impedance, rigid: 0
  bool drags_ = false;      ///< whether any alpha is above 0
  std::vector<double> strain_, rate_; ///< scratch of accept()
};

} // namespace tremolo::freefield
