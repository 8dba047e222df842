#pragma once

// What a point of PM4Sand remembers. Compression positive, in the axes of the material. Back stress ratio and
// fabric are traceless; the apparent initial back stress is made component by component and need not be.

#include "materials/tensor/deviator.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace tremolo::materials::pm4 {

/// Components of a tensor that are compared one by one.
struct Components {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  Deviator deviator() const { return {0.5 * (xx - yy), xy}; }
  static Components of(Deviator t) { return {t.d, -t.d, t.s}; }
};

/// In-plane effective stress, Pa.
struct Stress {
  double p = 0.0;
  Deviator s;
};

/// What changes at every step.
struct Motion {
  Deviator alpha;                 ///< back stress ratio
  Deviator z;                     ///< fabric
  double z_cum = 0.0;             ///< cumulated fabric
  double z_peak = 0.0;            ///< largest fabric so far
  double volumetric_strain = 0.0; ///< since the start, compression positive
  double gap = 0.0;               ///< opening since the effective stress vanished, a volumetric strain
};

/// What follows from the initial stress and stays.
struct Initial {
  double z_max = 0.0;
  double A_do = 0.0;
  double p_min = 0.0; ///< Pa
  Stress offset;      ///< of the reported stress from the one that the surfaces can hold, Pa
};

/// What changes at a reversal only.
struct Memory {
  double p_zp = 0.0;      ///< p at the reversal with the largest z p, Pa
  double zp_max = -1.0;   ///< the largest |z| p at a reversal, Pa; negative before the first one
  Deviator z_in;          ///< fabric at the last reversal
  Components alpha_in;    ///< apparent back stress ratio at the last reversal
  Deviator alpha_in_p;    ///< the one before
  Deviator alpha_in_true; ///< true back stress ratio at the last reversal
  Components alpha_max;   ///< largest components at reversals on the negative side
  Components alpha_min;   ///< smallest components at reversals on the positive side
};

/// The state block of a point: doubles only, in the order of state_variables(const Pm4Sand&).
struct State {
  double angle = 0.0; ///< by which the material has turned, rad
  Motion now;
  Initial start;
  Memory memory;
};

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
inline double floor_pressure(const Initial& start) {
  return 0.2 * start.p_min;
}

} // namespace tremolo::materials::pm4
