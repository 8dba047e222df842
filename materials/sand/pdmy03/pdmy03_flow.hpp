#pragma once

// The volumetric part P'' of plastic flow (a third of its trace over the length of the deviatoric part). With
// R the stress ratio over the one at phase transformation,
//
//     dilation      P'' = (R - 1)^2 (d_a + gamma_d^d_b) (H/p_a)^-d_c     beyond the zone, 0 inside it,
//     contraction   P'' = -(R cos(theta) - 1)^2 (c_a + eps_c c_b) max(0.1, (H/p_a)^c_c) C,
//                   C = [1 + (c_d |CSR - CSR_0|)^3] (1 + c_e CSR_0)^2
//
// (Khosravifar et al. 2018; Yang et al. 2003; the zone: pdmy03_zone.hpp). CSR is the shear stress on the
// plane that was horizontal at the start, in the axes of the material. Four points at a time, some of which
// take part.

#include "materials/sand/pdmy03/pdmy03_zone.hpp"
#include "materials/tensor/elementary.hpp"

namespace tremolo::materials {

/// Void ratio on the critical state line, e_cr = 0.9 - 0.02 (p'/p_a)^0.7, and that at zero strain.
namespace pdmy03_critical {
inline constexpr double void_ratio = 0.6;
inline constexpr double intercept = 0.9;
inline constexpr double slope = 0.02;
inline constexpr double exponent = 0.7;
} // namespace pdmy03_critical

/// Stresses between which a part of an increment goes, and where the flow rule is asked.
struct FlowStress {
  Deviators3 start; ///< deviators, Pa
  Deviators3 trial;
  Deviators3 contact;
  Lanes start_height; ///< p' + p_res, Pa
  Lanes height;       ///< of trial and contact
  Lanes start_volume; ///< volumetric strains
  Lanes volume;
};

/// C
inline Lanes cyclic_factor(const Pdmy03& law, const Lanes& shear_ratio, const Lanes& initial_shear_ratio) {
  const Lanes change = law.contraction[3] * magnitude(shear_ratio - initial_shear_ratio);
  const Lanes bias = 1.0 + law.contraction[4] * initial_shear_ratio;
  return (1.0 + change * change * change) * bias * bias;
}

/// Lanes in which a part of an increment crosses the critical state line.
inline LaneMask crosses_critical_state(const Pdmy03& law, const FlowStress& stress) {
  namespace critical = pdmy03_critical;
  const auto void_ratio = [](const Lanes& volume) {
    return critical::void_ratio + volume * (1.0 + critical::void_ratio);
  };
  const Lanes e0 = void_ratio(stress.start_volume);
  const Lanes e1 = void_ratio(stress.volume);
  const Lanes x0 = (stress.start_height - law.residual_pressure) / law.atmospheric_pressure;
  const Lanes x1 = (stress.height - law.residual_pressure) / law.atmospheric_pressure;
  // x^0.7 <= max(1, x): well below the line without a power
  const LaneMask near =
      ~(larger(e0, e1) < critical::intercept - critical::slope * larger(all(1.0), larger(x0, x1)));
  if (!any(near))
    return near;
  const auto line = [](const Lanes& x) {
    return critical::intercept - critical::slope * elementary::pow(positive(x), critical::exponent);
  };
  return near & ((e0 < line(x0)) ^ (e1 < line(x1)));
}

inline Lanes dilation_flow(const Pdmy03& law, const Lanes& beyond, const Lanes& strain, const Lanes& height) {
  constexpr double largest = 5e4;
  const auto& d = law.dilation;
  const Lanes flow = beyond * beyond * (d[0] + elementary::pow(strain, d[1])) *
                     elementary::pow(height / law.atmospheric_pressure, -d[2]);
  return smaller(flow, all(largest));
}

/// cos(theta) between the stress and its change, both as ratios.
inline Lanes loading_cosine(const FlowStress& stress) {
  const Deviators3 change = (1.0 / stress.height) * stress.trial - (1.0 / stress.start_height) * stress.start;
  const Lanes lengths = sqrt(dot(stress.start, stress.start) * dot(change, change));
  return choose(lengths > 0.0, dot(stress.start, change) / lengths, all(1.0));
}

inline Lanes contraction_flow(const Pdmy03& law, const Lanes& ratio, const Lanes& total, const Lanes& height,
                              const Lanes& factor) {
  const auto& c = law.contraction;
  const Lanes pressure = larger(all(0.1), elementary::pow(height / law.atmospheric_pressure, c[2]));
  return -(ratio - 1.0) * (ratio - 1.0) * (c[0] + total * c[1]) * pressure * factor;
}

/// P'' of one part of an increment; moves the perfectly plastic zone.
/// @param which  the points that take this part
inline Lanes volumetric_flow(const Pdmy03& law, Pdmy03States& state, const LaneMask& which,
                             const IncrementStart& start, const FlowStress& stress,
                             const FlowStrain& strain) {
  const Lanes to_ratio = std::sqrt(1.5) / stress.height;
  const Lanes relative = norm(stress.contact) * to_ratio / law.transformation_ratio;
  const Lanes start_ratio = norm(stress.start) * std::sqrt(1.5) / stress.start_height;
  const LaneMask rises = (relative >= 1.0) & (norm(stress.trial) * to_ratio >= start_ratio) &
                         (dot(stress.start, stress.trial) >= 0.0);
  Lanes flow{};
  if (const LaneMask above = which & rises; any(above)) {
    dilate(law, state, above, start, strain);
    if (const LaneMask dilates = above & (state.zone == pdmy03_zone::dilating); any(dilates))
      flow = choose(dilates, dilation_flow(law, relative - 1.0, state.dilation, stress.height), flow);
  }
  if (const LaneMask below = which & ~rises; any(below)) {
    const Lanes contraction = contraction_flow(law, relative * loading_cosine(stress), state.dilation_total,
                                               stress.height, start.cyclic_factor);
    flow = choose(below, contraction, flow);
    leave_dilation(law, state, below, start, strain);
  }
  return choose(crosses_critical_state(law, stress), Lanes{}, flow);
}

} // namespace tremolo::materials
