#pragma once

// Selection of the combinations of axis values that a study runs.

#include "scene/study.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tremolo::app {

/// A value an axis, in the order of the axes.
using Combination = std::vector<scene::AxisValue>;

/// A Latin hypercube: `samples` points of the unit cube with `dimensions` coordinates in [0, 1).
///
/// Each coordinate is (p(i) + u) / samples with a random permutation p of 0 .. samples - 1 and u uniform in
/// [0, 1), so that one point lies in each n-th of each axis (McKay, Beckman & Conover 1979, Technometrics 21,
/// 239-245). A seed gives equal points on every machine.
std::vector<std::vector<double>> latin_hypercube(std::size_t samples, std::size_t dimensions,
                                                 std::uint32_t seed);

/// Every combination of the values of some axes; the last axis turns fastest.
std::vector<Combination> product(const std::vector<scene::Axis>& axes);

/// The combinations of a study's design. An axis with one value has it in every run.
/// @param axes  of the study, with the motions that were made for it
std::vector<Combination> combinations(const scene::Study& study, const std::vector<scene::Axis>& axes);

} // namespace tremolo::app
