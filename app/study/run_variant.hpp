#pragma once

#include "app/study/variant.hpp"

#include <filesystem>

namespace tremolo::app {

/// What a run has taken.
struct RunCost {
  double sources = 0.0; ///< CPU time of the free fields, s
  double domain = 0.0;  ///< CPU time of the domain, s
  double wall = 0.0;    ///< s
  double updates = 0.0; ///< of particles
};

/// Runs a variant whose text is a case, on this machine.
/// @param folder  not there yet
/// @throws Exit where the run fails; it has been said
RunCost run_variant(const Variant& variant, const std::filesystem::path& folder, int threads);

} // namespace tremolo::app
