#pragma once

#include "scene/case.hpp"

#include <vector>

namespace tremolo::app {

/// How many ranks the run's machine takes, and then each machine of [hosts.domain]: as evenly as what they
/// take at most allows, and those of a machine one behind the other, since neighbours on the curve of tiles
/// have the most to say to each other.
/// @param here        most of the run's machine, and of those that say no number of their own
/// @param beyond      whether they take more if they must
/// @throws std::invalid_argument where they do not take as many
std::vector<int> rank_places(int count, const std::vector<scene::RankMachine>& machines, int here,
                             bool beyond);

} // namespace tremolo::app
