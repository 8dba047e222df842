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
#include <bit>
#include <cstddef>
#include <cstring>

namespace tremolo::materials {

/// Leading variables of a state block, in the order of state_variables(const Pdmy03&). Real is double for one
/// point, or Lanes for four.
template <typename Real>
struct Pdmy03StateOf {
  Real rotation{};         ///< of the material since the start, rad
  Real active_surface{};   ///< 0 inside all of them
  Real zone{};             ///< pdmy03_zone
  Real zone_size{};        ///< octahedral strain
  Real dilation{};         ///< gamma_d
  Real dilation_total{};   ///< eps_c
  Real zone_translation{}; ///< octahedral strain
  Real damage{};           ///< when dilation began
  Real largest_pressure{}; ///< Pa
  Real gap{};              ///< volumetric expansion beyond zero effective stress
  Real volume_strain{};
  Real initial_height{}; ///< H_0, Pa
  Real initial_shear_ratio{};
  Deviator3Of<Real> strain;
  Deviator3Of<Real> pivot;           ///< strain where dilation was last in progress
  Deviator3Of<Real> zone_centre;     ///< strain
  Deviator3Of<Real> pivot_direction; ///< strain increment with which dilation last began
  Deviator3Of<Real> active_centre;
};
using Pdmy03State = Pdmy03StateOf<double>;

/// Whether shear strain is inside the perfectly plastic zone, as the state says it.
namespace pdmy03_zone {
inline constexpr double never_reached = -1.0; ///< the phase transformation line
inline constexpr double left_dilation = 0.0;  ///< contracting after having dilated
inline constexpr double inside = 1.0;         ///< perfectly plastic
inline constexpr double dilating = 2.0;       ///< beyond it
} // namespace pdmy03_zone

/// Doubles of the state; the centres of resting surfaces come behind them.
inline constexpr std::size_t pdmy03_fixed_size = sizeof(Pdmy03State) / sizeof(double);

/// Doubles that the centres of surfaces 1 to N-1 take.
constexpr std::size_t packed_centres(std::size_t surfaces) {
  return (3 * (surfaces - 1) + 1) / 2;
}

/// Length of the state block.
constexpr std::size_t pdmy03_state_size(std::size_t surfaces) {
  return pdmy03_fixed_size + packed_centres(surfaces);
}

inline Pdmy03State load_pdmy03(const double* block) {
  std::array<double, pdmy03_fixed_size> values;
  std::memcpy(values.data(), block, sizeof values);
  return std::bit_cast<Pdmy03State>(values);
}

inline void store(const Pdmy03State& state, double* block) {
  std::memcpy(block, &state, sizeof state);
}

/// The centres of surfaces as they were left when last touched, in one block; constant as a view, not in what
/// it views.
class RestingCentres {
public:
  RestingCentres(double* block, std::size_t surfaces)
      : first_(reinterpret_cast<unsigned char*>(block + pdmy03_fixed_size)), surfaces_(surfaces) {}

  /// The centre of surface i, counted from 1; zero for the failure surface.
  Deviator3 operator[](std::size_t i) const {
    if (i >= surfaces_)
      return {};
    std::array<float, 3> packed{};
    std::memcpy(packed.data(), place(i), sizeof packed);
    return {packed[0], packed[1], packed[2]};
  }
  void set(std::size_t i, const Deviator3& centre) const {
    const std::array<float, 3> packed = {static_cast<float>(centre.a), static_cast<float>(centre.b),
                                         static_cast<float>(centre.c)};
    std::memcpy(place(i), packed.data(), sizeof packed);
  }

private:
  unsigned char* place(std::size_t i) const { return first_ + 3 * (i - 1) * sizeof(float); }

  unsigned char* first_;
  std::size_t surfaces_;
};

} // namespace tremolo::materials
