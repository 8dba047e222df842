#pragma once

#include "scene/keys/keys.hpp"

namespace tremolo::scene {

/// [[structure]] and what stands below it.
std::vector<Table> structure_keys();

/// [[lining]] and what stands below it.
std::vector<Table> lining_keys();

/// [[section]] and what stands below it.
std::vector<Table> section_keys();

/// [[prop]] and what stands below it.
std::vector<Table> prop_keys();

/// Friction and adhesion against a soil.
Table against_table(std::string_view name, std::string_view meaning);

/// A circle, in place of a polygon.
Table circle_table(std::string_view name, std::string_view meaning);

} // namespace tremolo::scene
