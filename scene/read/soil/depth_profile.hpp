#pragma once

// A value of a soil that varies over depth, as a key of its table gives it.

#include "scene/keys/keys.hpp"

#include <toml++/toml.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tremolo::scene {

/// { depth = [...], value = [...] } or { elevation = [...], value = [...] }: linear between its points.
struct LevelTable {
  bool by_depth = false;      ///< below [surface] level; otherwise y
  std::vector<double> levels; ///< depths or elevations, rising, m
  std::vector<double> values;
};

/// { reference = R, stress = p, exponent = n }: R (sigma'_v / p)^n of the vertical effective stress sigma'_v.
struct StressPower {
  double reference = 0.0; ///< R
  double stress = 0.0;    ///< p, Pa
  double exponent = 0.0;  ///< n
};

using DepthProfile = std::variant<LevelTable, StressPower>;

/// The profiles of a file by the path of their keys, "soil.clay.vs".
using DepthProfiles = std::map<std::string, DepthProfile, std::less<>>;

/// Position at which a profile is evaluated: the middle of a slice.
struct SlicePlace {
  double y = 0.0;                 ///< m
  double depth = 0.0;             ///< below [surface] level, m
  std::optional<double> stress{}; ///< vertical effective stress of the level ground, Pa; none above it
};

/// The forms of a profile, for texts.
inline constexpr std::string_view profile_forms =
    "{ depth = [...], value = [...] }, { elevation = [...], value = [...] } or "
    "{ reference = ..., stress = ..., exponent = ... }";

/// Reads a profile.
/// @param refuse  called with what is wrong, and where
std::optional<DepthProfile> read_profile(const Key& key, const toml::table& table,
                                         const std::function<void(const toml::node&, std::string)>& refuse);

/// The value at a place, that of the nearest point beyond the ends of a table; nothing of a power of a stress
/// that is not there.
std::optional<double> value_at(const DepthProfile& profile, const SlicePlace& place);

/// A value that the profile has somewhere: what its soil is first read with.
double typical_value(const DepthProfile& profile);

/// The profile as TOML.
std::string text(const DepthProfile& profile);

} // namespace tremolo::scene
