#pragma once

#include "coupler/launch/launcher.hpp"
#include "scene/case.hpp"

namespace tremolo::app {

/// The ranks that share the domain of a run.
struct DomainRanks {
  int count = 1;
  bool oversubscribe = false; ///< whether there may be more than the machine has processors
};

/// Ranks of a run; more are a slip of the finger.
inline constexpr int most_ranks = 4096;

/// Refuses, before anything is started, ranks that cannot be started here or cannot share the domain.
/// @throws std::runtime_error, std::invalid_argument with the reason and what to do
void check_ranks(const scene::Case& scene, const DomainRanks& ranks);

/// Lets mpirun start the domain's process as several ranks.
void start_as_ranks(coupler::ProcessSpec& domain, const DomainRanks& ranks);

} // namespace tremolo::app
