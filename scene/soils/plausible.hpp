#pragma once

// Values that a key may have and that yet are hardly meant: a strength of 25 Pa is one of 25 kPa, a
// permeability of 1e-11 m/s in sand one of 1e-11 m2. One table holds what soil, rock, water and structures
// have, for all keys of all files, and which other units a number is likely to be in.

#include "scene/case.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene {

/// Why a number is likely to be in another unit, with what it would be in that unit; nothing if the value
/// is plausible, and for keys that the table does not hold.
/// @param path   of the key in its file, "soil.clay.young", "profile[2].density"
/// @param model  of the soil that the key belongs to, empty for others
std::optional<std::string> unit_doubt(std::string_view path, double value, std::string_view model = {});

/// The doubts about all values of a file, defaults excepted, as pairs of path and text.
std::vector<std::pair<std::string, std::string>> unit_doubts(const std::vector<ValueInForce>& values);

} // namespace tremolo::scene
