#pragma once

// The memory of one point: a flat block of doubles. Everything with a direction is kept in the axes of the
// material (material_axes.hpp), deviators by their three orthonormal components (deviator3.hpp).
//
// Surfaces move one at a time: only the active one needs all digits of its centre, because it moves a little
// in every step. The others stand still until a reversal resets them and are kept as floats, two in a double;
// a finite float in the upper half never makes the double a NaN. The failure surface does not move at all.

#include "materials/sand/pdmy03/pdmy03.hpp"
#include "materials/tensor/deviator3.hpp"

#include <array>
#include <cstddef>
#include <cstring>

namespace tremolo::materials {

/// Places in the state block.
namespace pdmy03_state {
enum Place : std::size_t {
  rotation,
  active_surface,
  zone,
  zone_size,
  dilation,
  dilation_total,
  zone_translation,
  damage,
  largest_pressure,
  gap,
  volume_strain,
  initial_height,
  initial_shear_ratio,
  strain,
  pivot = strain + 3,
  zone_centre = pivot + 3,
  pivot_direction = zone_centre + 3,
  active_centre = pivot_direction + 3,
  centres = active_centre + 3
};
} // namespace pdmy03_state

/// Whether shear strain is inside the perfectly plastic zone, as the state block says it.
namespace pdmy03_zone {
inline constexpr double never_reached = -1.0; ///< the phase transformation line
inline constexpr double left_dilation = 0.0;  ///< contracting after having dilated
inline constexpr double inside = 1.0;         ///< perfectly plastic
inline constexpr double dilating = 2.0;       ///< beyond it
} // namespace pdmy03_zone

/// Doubles that the centres of surfaces 1 to N-1 take.
constexpr std::size_t packed_centres(std::size_t surfaces) {
  return (3 * (surfaces - 1) + 1) / 2;
}

/// Length of the state block.
constexpr std::size_t pdmy03_state_size(std::size_t surfaces) {
  return pdmy03_state::centres + packed_centres(surfaces);
}

/// A view of one state block; constant as a view, not in what it views.
class Pdmy03Memory {
public:
  explicit Pdmy03Memory(double* block) : block_(block) {}

  double& operator[](pdmy03_state::Place place) const { return block_[place]; }

  Deviator3 deviator(pdmy03_state::Place place) const {
    return {block_[place], block_[place + 1], block_[place + 2]};
  }
  void set(pdmy03_state::Place place, const Deviator3& value) const {
    block_[place] = value.a;
    block_[place + 1] = value.b;
    block_[place + 2] = value.c;
  }

  /// Centre of surface i of n as it was left when the surface was last touched; zero for the failure surface.
  Deviator3 resting_centre(std::size_t i, std::size_t n) const {
    if (i >= n)
      return {};
    std::array<float, 3> packed{};
    std::memcpy(packed.data(), floats(i), sizeof packed);
    return {packed[0], packed[1], packed[2]};
  }
  void rest_centre(std::size_t i, const Deviator3& centre) const {
    const std::array<float, 3> packed = {static_cast<float>(centre.a), static_cast<float>(centre.b),
                                         static_cast<float>(centre.c)};
    std::memcpy(floats(i), packed.data(), sizeof packed);
  }

private:
  unsigned char* floats(std::size_t i) const {
    return reinterpret_cast<unsigned char*>(block_ + pdmy03_state::centres) + 3 * (i - 1) * sizeof(float);
  }

  double* block_;
};

} // namespace tremolo::materials
