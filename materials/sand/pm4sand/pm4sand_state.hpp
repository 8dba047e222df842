#pragma once

// State of a point of PM4Sand, compression positive, in the axes of the material. Back stress ratio and
// fabric are traceless; the apparent initial back stress is made component by component and need not be. Real
// is double for one point, or Lanes for four (pm4sand_four.hpp).

#include "materials/tensor/deviator.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace tremolo::materials::pm4 {

using tremolo::choose; // beside those for four points (pm4sand_four.hpp)

/// Components of a tensor that are compared one by one.
template <typename Real>
struct ComponentsOf {
  Real xx{};
  Real yy{};
  Real xy{};
  DeviatorOf<Real> deviator() const { return {0.5 * (xx - yy), xy}; }
  static ComponentsOf of(const DeviatorOf<Real>& t) { return {t.d, -t.d, t.s}; }
};
using Components = ComponentsOf<double>;

/// The in-plane effective stress, Pa.
template <typename Real>
struct StressOf {
  Real p{};
  DeviatorOf<Real> s;
};
using Stress = StressOf<double>;

/// Variables that change at every step.
template <typename Real>
struct MotionOf {
  DeviatorOf<Real> alpha;   ///< back stress ratio
  DeviatorOf<Real> z;       ///< fabric
  Real z_cum{};             ///< cumulated fabric
  Real z_peak{};            ///< largest fabric so far
  Real volumetric_strain{}; ///< since the start, compression positive
  Real gap{};               ///< opening since the effective stress vanished, a volumetric strain
};
using Motion = MotionOf<double>;

/// Constants that follow from the initial stress.
template <typename Real>
struct InitialOf {
  Real z_max{};
  Real A_do{};
  Real p_min{};          ///< Pa
  StressOf<Real> offset; ///< of the reported stress from the one that the surfaces can hold, Pa
};
using Initial = InitialOf<double>;

/// Variables that change at a reversal only.
template <typename Real>
struct MemoryOf {
  Real p_zp{};                        ///< p at the reversal with the largest z p, Pa
  Real zp_max = constant<Real>(-1.0); ///< the largest |z| p at a reversal, Pa; negative before the first one
  DeviatorOf<Real> z_in;              ///< fabric at the last reversal
  ComponentsOf<Real> alpha_in;        ///< apparent back stress ratio at the last reversal
  DeviatorOf<Real> alpha_in_p;        ///< the one before
  DeviatorOf<Real> alpha_in_true;     ///< true back stress ratio at the last reversal
  ComponentsOf<Real> alpha_max;       ///< largest components at reversals on the negative side
  ComponentsOf<Real> alpha_min;       ///< smallest components at reversals on the positive side
};
using Memory = MemoryOf<double>;

/// The state block of a point: doubles only, in the order of state_variables(const Pm4Sand&).
template <typename Real>
struct StateOf {
  Real angle{}; ///< by which the material has turned, rad
  MotionOf<Real> now;
  InitialOf<Real> start;
  MemoryOf<Real> memory;
};
using State = StateOf<double>;

inline constexpr std::size_t state_size = 32;
static_assert(sizeof(State) == state_size * sizeof(double));

inline State load(const double* block) {
  std::array<double, state_size> values;
  std::memcpy(values.data(), block, sizeof(State));
  return std::bit_cast<State>(values);
}

/// The part of a block that the initial stress decides.
inline Initial load_start(const double* block) {
  std::array<double, sizeof(Initial) / sizeof(double)> values;
  std::memcpy(values.data(), block + offsetof(State, start) / sizeof(double), sizeof(Initial));
  return std::bit_cast<Initial>(values);
}

inline void store(const State& state, double* block) {
  std::memcpy(block, &state, sizeof(State));
}

/// Stress is kept above this part of p_min.
template <typename Real>
Real floor_pressure(const InitialOf<Real>& start) {
  return 0.2 * start.p_min;
}

} // namespace tremolo::materials::pm4
