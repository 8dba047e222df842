#pragma once

#include "freefield/marched/block_tridiagonal.hpp"
#include "freefield/marched/marched_state.hpp"

#include <vector>

namespace tremolo::freefield {

/// The derivative of a trial's residual (marched_trial.hpp) with elastic soil, factored: what corrects an
/// increment.
class MarchedTangent {
public:
  explicit MarchedTangent(std::size_t elements) : matrix_(elements) {}

  /// @param moduli  M of each element, Pa
  void factor(const MarchedScheme& scheme, const MarchedState& state, const std::vector<double>& moduli);

  /// Factors again where a modulus or a length has left what was factored by more than a per cent: less than
  /// that costs the iteration nothing.
  void follow(const MarchedScheme& scheme, const MarchedState& state, const std::vector<double>& moduli);

  /// Replaces a residual by the correction of the increment that takes it away where soil is elastic.
  void solve(Increments& residual);

private:
  BlockTridiagonal<4> matrix_;
  Eigen::Array<double, 4, Eigen::Dynamic> blocks_; ///< of a right-hand side
  std::vector<double> modulus_, length_;           ///< that were factored, Pa and m
};

} // namespace tremolo::freefield
