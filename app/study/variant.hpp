#pragma once

// A variant of a case: the case with other values of some of its keys, in a folder of its own. A study makes
// some variants, runs them and compares what they have computed.

#include "app/study/design.hpp"
#include "scene/case.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::app {

struct Variant {
  std::string name;                 ///< of its folder in that of the study
  std::string text;                 ///< of its case
  Combination values;               ///< one an axis
  std::optional<scene::Case> scene; ///< none where the text is no case
  std::string refused;              ///< why it has no results; empty until that is known
};

/// Reads the text as a case that stands where the given one does; says why where it is none.
Variant variant_of(const scene::Case& given, std::string name, std::string text, Combination values = {});

/// The costs of a run.
struct RunCost {
  double sources = 0.0; ///< CPU time of the free fields, s
  double domain = 0.0;  ///< CPU time of the domain, s
  double wall = 0.0;    ///< s
  double updates = 0.0; ///< of particles
};

/// Runs a variant whose text is a case, on this machine.
/// @param folder  not there yet
/// @throws Exit where the run fails; the reason has been printed
RunCost run_variant(const Variant& variant, const std::filesystem::path& folder, int threads);

/// "mesh.size = 0.5, time.transfer = apic": the values of the axes that are to be named, all at first.
std::string setting(
    const std::vector<scene::Axis>& axes, const Combination& values,
    const std::function<bool(const scene::Axis&)>& named = [](const scene::Axis&) { return true; });

} // namespace tremolo::app
