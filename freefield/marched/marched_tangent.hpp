#pragma once

#include "freefield/fe/block_tridiagonal.hpp"
#include "freefield/marched/marched_state.hpp"

#include <vector>

namespace tremolo::freefield {

/// The derivative of a trial's residual (marched_trial.hpp) with elastic soil, factored: what corrects an
/// increment.
class MarchedTangent {
public:
  explicit MarchedTangent(std::size_t elements) : matrix_(elements) {}

  /// @param moduli  M of each element, Pa
  void factor(const MarchedScheme& scheme, const WetGrid& grid, const std::vector<double>& moduli);

  /// Replaces a residual by the correction of the increment that takes it away where soil is elastic.
  void solve(std::vector<double>& residual) const { matrix_.solve(residual); }

private:
  BlockTridiagonal<4> matrix_;
};

} // namespace tremolo::freefield
