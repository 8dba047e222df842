#pragma once

#include "freefield/profile.hpp"
#include "materials/hysteretic/backbone/backbone.hpp"

#include <cstddef>
#include <optional>

namespace tremolo::freefield {

/// The backbone of a layer that follows Masing rules in shear; nothing for a linear elastic one.
/// @throws std::invalid_argument for another law, naming the layer and the model that takes it
std::optional<materials::Backbone> shear_backbone(const Profile& profile, std::size_t layer);

} // namespace tremolo::freefield
