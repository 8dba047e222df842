#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tremolo::scene {

/// A key of a soil that varies over depth.
struct VaryingKey {
  std::string key;            ///< "vs"
  std::string unit;           ///< as in the reference of keys
  std::string profile;        ///< as TOML
  std::vector<double> values; ///< of the slices, from the top down
};

/// The slices into which a soil with keys that vary over depth is cut, each with constant values.
struct SoilProfile {
  std::size_t first = 0;      ///< index of the uppermost slice in Case::soils; the others follow it
  std::vector<double> levels; ///< y of the upper edge of each slice, then of the lower edge of the last, m
  std::vector<VaryingKey> keys;

  std::size_t slices() const { return levels.size() - 1; }
  /// Whether an index into Case::soils is that of a slice.
  bool has(std::size_t soil) const { return soil >= first && soil < first + slices(); }
};

} // namespace tremolo::scene
