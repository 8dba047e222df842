#pragma once

// A step of Hilber, Hughes and Taylor's method with nonlinear soil, beta_N = (1 - alpha)^2/4, gamma = 1/2 -
// alpha (scalar_column.cpp). Unknown is a', the acceleration at the step's end:
//
//     g(a') = m a' + (1 + alpha) r(u', v') - alpha r = 0,
//     J = m + (1 + alpha) [gamma dt c + B^T (beta_N dt^2 D + gamma dt beta D_0) B].
//
// The soil is taken from the step's beginning in one increment of strain at every iterate, so that unfinished
// iterations leave no trace in its history. D is the derivative of that update, or D_0.

#include "freefield/fe/block_tridiagonal.hpp"
#include "freefield/fe/fe_elements.hpp"
#include "freefield/fe/fe_soil.hpp"
#include "freefield/fe/scalar_column.hpp"

#include <optional>

namespace tremolo::freefield {

/// The stiffness that Newton's method takes in a column with nonlinear layers.
enum class Tangent {
  consistent, ///< of the law's own update at the present iterate: few iterations
  initial     ///< at small strain (modified Newton), factored once: many cheap iterations
};

/// How the column moves, two values a node.
struct FeMotion {
  std::vector<double> u, v, a;         ///< m, m/s, m/s2
  std::vector<double> stress_velocity; ///< that the damping stress takes, m/s
  std::vector<double> r;               ///< resistance, Pa
  BaseMotion base;

  explicit FeMotion(std::size_t freedoms)
      : u(freedoms), v(freedoms), a(freedoms), stress_velocity(freedoms), r(freedoms) {}
};

/// Everything that a step changes.
struct FeState : FeMotion {
  SoilState soil;

  FeState(std::size_t freedoms, const SoilState& initial) : FeMotion(freedoms), soil(initial) {}
};

/// Moves the prescribed degrees of freedom with the base.
void hold_base(const FeElements& elements, FeMotion& motion);

class FeNewton {
public:
  FeNewton(double hht_alpha, Tangent tangent, double tolerance);

  /// Makes `end` of `begin`, dt later, with end.base given.
  /// @param traction_scale  the largest traction so far, Pa, against which the residual is measured
  /// @return whether the iterations converged; otherwise `end` means nothing
  bool step(const FeElements& elements, const FeSoil& soil, const FeState& begin, double dt,
            double traction_scale, FeState& end);

  long iterations() const { return iterations_; }
  /// The element below the node with the largest residual of the last iteration.
  std::size_t worst_element() const { return worst_element_; }

private:
  struct Factored {
    double dt = 0.0;
    BlockTridiagonal<2> matrix;
  };

  double residual(const FeElements& elements, const FeState& begin, const FeState& end,
                  std::vector<double>& g);
  BlockTridiagonal<2> jacobian(const FeElements& elements, double dt, const std::vector<Stiffness>& soil,
                               const std::vector<Stiffness>& initial) const;

  HhtParameters hht_;
  Tangent tangent_;
  double tolerance_;
  std::optional<Factored> initial_; ///< of the stiffness at small strain, for the step it was made for
  long iterations_ = 0;
  std::size_t worst_element_ = 0;
};

} // namespace tremolo::freefield
