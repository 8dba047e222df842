#pragma once

#include "scene/read/read.hpp"
#include "scene/read/soil/depth_profile.hpp"

namespace tremolo::scene {

/// The most slices into which a soil may be cut.
inline constexpr double most_slices = 500.0;

/// Cuts every soil with keys that vary over depth into horizontal slices as high as the cells of the mesh,
/// each a soil with the values of its middle, and with them the regions and the layers of this soil; after
/// all of these have been read without errors. Soils and layers of [[profile]] take the factors of
/// [random_profile] likewise, in slices from interface to interface.
/// @param root      the file
/// @param profiles  what reading has found
void slice_soils(const toml::table& root, const DepthProfiles& profiles, Findings& findings, Case& scene);

} // namespace tremolo::scene
