#pragma once

#include "scene/case.hpp"

#include <vector>

namespace tremolo::app {

/// Numbers of ranks on the run's machine and then on each machine of [hosts.domain], as even as their limits
/// allow. Ranks on a machine are consecutive, since neighbours on the curve of tiles exchange the most data.
/// @param here        most of the run's machine, and of those that say no number of their own
/// @param beyond      whether they take more if they must
/// @throws std::invalid_argument where they do not take as many
std::vector<int> rank_places(int count, const std::vector<scene::RankMachine>& machines, int here,
                             bool beyond);

} // namespace tremolo::app
