#pragma once

// The limits of each free-field model, and the models that can compute what another cannot: a refusal names
// only alternatives that exist.

#include "scene/case.hpp"

#include <string>
#include <vector>

namespace tremolo::scene {

/// Why a model cannot compute the wave, and the layers under a surface (m); empty if it can.
std::string refused_wave(const Case& scene, SourceModel model, double surface,
                         const std::vector<Layer>& layers);
std::string refused_soil(const Case& scene, SourceModel model, const std::vector<Layer>& layers);

/// "; use ...": the models that take the case as it is, and what else would let `model` or others take it.
std::string other_ways(const Case& scene, SourceModel model, double surface,
                       const std::vector<Layer>& layers);

} // namespace tremolo::scene
