#pragma once

// Layout of a step's values in datasets, shared by the writer and the reader of exchanges.

#include "results/hdf5/hdf5_read.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tremolo::results {

/// A dataset [steps, points, components], and where its components stand among the values of a point.
struct Quantity {
  std::string_view name;
  std::string_view unit;
  std::size_t first = 0;
  std::size_t components = 0;
};

/// Quantities that a source sends for each level.
inline constexpr std::array<Quantity, 4> field_quantities{{{"velocity", "m/s", 0, 2},
                                                           {"stress", "Pa", 2, 3},
                                                           {"velocity_rate", "m/s2", 5, 2},
                                                           {"stress_rate", "Pa/s", 7, 3}}};

/// Quantities that the hub sends for each face in mode lockstep.
inline constexpr std::array<Quantity, 3> traction_quantities{
    {{"traction", "Pa", 0, 2}, {"free_field_velocity", "m/s", 2, 2}, {"free_field_stress", "Pa", 4, 3}}};

/// Columns of the datasets of frames: first step, steps, CRC-32.
inline constexpr std::size_t frame_columns = 3;

inline constexpr std::string_view exchange_content = "exchange";

} // namespace tremolo::results
