#pragma once

// Keys of the numbers that laws take. Their names, units, meanings and ranges stand beside the laws; a name
// that several models have is one key, which says where they differ.

#include "materials/law/parameter.hpp"
#include "scene/choices.hpp"
#include "scene/keys/keys.hpp"

#include <span>
#include <vector>

namespace tremolo::scene {

/// The numbers that the law of a model takes, with the elastic constants.
std::span<const materials::Parameter> parameters_of(SoilModel model);

/// The key of a number.
Key key_of(const materials::Parameter& parameter);

/// One key for each name of all models.
std::vector<Key> law_keys();

} // namespace tremolo::scene
