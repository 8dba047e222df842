#pragma once

// Mixed control of a point: some components of a step are prescribed as strain increments, the others (free)
// as stresses at its end. With sigma(x) the stress after the strain increment x, Newton's method finds the
// free x of
//
//     r_i(x) = sigma_i(x) + K tr(x) - target_i = 0      for the free components i,
//
// K the stiffness of pore water if the targets are total stresses, else 0. The tangent is made by finite
// differences over a hundredth of the step, kept from step to step, and corrected after Broyden (1965, Math.
// Comp. 19, 577-593) as long as the residual halves; a new one is made where it does not, with a line search
// on top.
//
// r need not be monotonic: with one free component a law may hold the stress at more than one strain, or at
// none near where the last increments lead. The root next to there is taken. Where even that lies half a step
// or more away, on another branch, that is reported, and in the steps that follow the branch that was left is
// looked for first: it is come back to once its root lies where its last steady increments lead.

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

namespace tremolo::materials {

/// Components in the order xx, yy, xy (engineering shear strain; stress), zz.
using Components = std::array<double, 4>;

/// Prescribed values of a step.
struct MixedStep {
  std::array<bool, 4> by_stress = {};
  Components value = {};       ///< strain increments, or stresses at the end of the step, Pa
  double pore_stiffness = 0.0; ///< K, Pa
};

/// Stress after a strain increment; false where the law refuses it.
using StressAfter = std::function<bool(const Components& strain, Components& stress)>;

/// Finds strain increments; remembers the tangent and the increments of the last step.
class MixedControl {
public:
  /// Result of a step.
  struct Found {
    Components strain = {};
    double missing =
        0.0;           ///< largest residual of a free component, Pa; infinite if the law refused every trial
    double leap = 0.0; ///< strain from where the free component was expected, if to another branch, else 0
    bool away = false; ///< whether the step is on another branch than the one before the leap
  };

  /// The best increment found for a step.
  /// @param wanted    residual to stop at, Pa
  /// @param accepted  residual that is good enough where the law lets it come no closer, Pa
  Found find(const MixedStep& step, const StressAfter& stress_after, double wanted, double accepted);

private:
  /// Increments of a step that was found.
  struct Increments {
    Components prescribed = {};
    Components strain = {};

    double ratio_to(const MixedStep& step) const;
  };

  std::array<bool, 4> by_stress_ = {};
  std::array<double, 16> tangent_ = {}; ///< d r / d x of the free components, row by row
  bool has_tangent_ = false;
  std::optional<Increments> last_;
  std::optional<Increments> steady_; ///< of the last step that was as expected
  bool away_ = false;                ///< from the branch of that step
};

} // namespace tremolo::materials
