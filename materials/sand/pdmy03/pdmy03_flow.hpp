#pragma once

// The volumetric part P'' of plastic flow (a third of its trace over the length of the deviatoric part), and
// the perfectly plastic zone. With R the stress ratio over the one at phase transformation,
//
//     dilation      P'' = (R - 1)^2 (d_a + gamma_d^d_b) (H/p_a)^-d_c     beyond the zone, 0 inside it,
//     contraction   P'' = -(R cos(theta) - 1)^2 (c_a + eps_c c_b) max(0.1, (H/p_a)^c_c) C,
//                   C = [1 + (c_d |CSR - CSR_0|)^3] (1 + c_e CSR_0)^2.
//
// Each crossing of the phase transformation line enters the zone, a sphere of strain deviators in which shear
// is perfectly plastic; leaving it starts a dilation. Its size grows with the strain under dilation, which is
// how cyclic mobility adds strain cycle by cycle (Khosravifar et al. 2018; Yang et al. 2003). CSR is the
// shear stress on the plane that was horizontal at the start, in the axes of the material.

#include "materials/sand/pdmy03/pdmy03_state.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials {

/// Void ratio on the critical state line, e_cr = 0.9 - 0.02 (p'/p_a)^0.7, and that at zero strain.
namespace pdmy03_critical {
inline constexpr double void_ratio = 0.6;
inline constexpr double intercept = 0.9;
inline constexpr double slope = 0.02;
inline constexpr double exponent = 0.7;
} // namespace pdmy03_critical

inline double octahedral_strain(const Deviator3& e) {
  return 2.0 / std::sqrt(3.0) * norm(e);
}

/// What the flow rule keeps from the start of an increment while its parts are taken.
struct IncrementStart {
  Deviator3 increment;        ///< deviator of the whole strain increment
  double damage = 0.0;        ///< ((p_max - p')/(p_max + p_res))^(1/4)
  double cyclic_factor = 1.0; ///< C
  bool turned = false;        ///< against the direction in which the last dilation began
};

/// Stresses between which a part of an increment goes, and where the flow rule is asked.
struct FlowStress {
  Deviator3 start; ///< deviators, Pa
  Deviator3 trial;
  Deviator3 contact;
  double start_height = 0.0; ///< p' + p_res, Pa
  double height = 0.0;       ///< of trial and contact
  double start_volume = 0.0; ///< volumetric strains
  double volume = 0.0;
};

/// Strain of a part of an increment.
struct FlowStrain {
  Deviator3 end;       ///< total strain deviator at its end
  double length = 0.0; ///< octahedral, of the part
};

/// C
inline double cyclic_factor(const Pdmy03& law, double shear_ratio, double initial_shear_ratio) {
  const double change = law.contraction[3] * std::abs(shear_ratio - initial_shear_ratio);
  const double bias = 1.0 + law.contraction[4] * initial_shear_ratio;
  return (1.0 + change * change * change) * bias * bias;
}

/// The zone follows the strain after a reversal.
inline void translate_zone(const Pdmy03& law, const Pdmy03Memory& memory, const IncrementStart& start,
                           const Deviator3& strain) {
  using Place = pdmy03_state::Place;
  if (law.liquefaction_1 != 0.0 && start.turned) {
    const double moved =
        start.damage * law.liquefaction_2 * octahedral_strain(strain - memory.deviator(Place::pivot));
    memory[Place::zone_translation] = std::max(memory[Place::zone_translation], moved);
  }
}

/// One more part of an increment above the phase transformation line.
inline void dilate(const Pdmy03& law, const Pdmy03Memory& memory, const IncrementStart& start,
                   const FlowStrain& strain) {
  using Place = pdmy03_state::Place;
  double& zone = memory[Place::zone];
  const bool already = zone == pdmy03_zone::dilating;
  if (law.liquefaction_1 == 0.0) {
    zone = pdmy03_zone::dilating;
    if (already)
      memory[Place::dilation] += strain.length;
    else if (start.turned)
      memory[Place::dilation] = 0.0;
    return;
  }
  if (already) {
    memory.set(Place::pivot, strain.end);
    memory[Place::dilation] += strain.length;
    memory[Place::dilation_total] += memory[Place::damage] * law.liquefaction_1 * strain.length;
    return;
  }
  memory[Place::damage] = start.damage; // and stays while it dilates
  double& size = memory[Place::zone_size];
  size = 0.5 * (memory[Place::zone_translation] + memory[Place::dilation_total]);
  if (zone == pdmy03_zone::left_dilation || (zone == pdmy03_zone::inside && start.turned)) {
    const Deviator3 pivot = memory.deviator(Place::pivot);
    const Deviator3 arm = pivot - memory.deviator(Place::zone_centre);
    const double length = octahedral_strain(arm);
    const double reach = size - memory[Place::zone_translation];
    memory.set(Place::zone_centre, length > 0.0 ? pivot - (reach / length) * arm : pivot);
  }
  if (octahedral_strain(strain.end - memory.deviator(Place::zone_centre)) > size) {
    zone = pdmy03_zone::dilating;
    memory[Place::dilation] = 0.0;
    memory[Place::zone_translation] = 0.0;
    memory.set(Place::pivot, strain.end);
    memory.set(Place::pivot_direction, start.increment);
  } else {
    translate_zone(law, memory, start, strain.end);
    zone = pdmy03_zone::inside;
  }
}

/// Whether a part of an increment crosses the critical state line.
inline bool crosses_critical_state(const Pdmy03& law, const FlowStress& stress) {
  namespace critical = pdmy03_critical;
  const auto void_ratio = [](double volume) {
    return critical::void_ratio + volume * (1.0 + critical::void_ratio);
  };
  const double e0 = void_ratio(stress.start_volume);
  const double e1 = void_ratio(stress.volume);
  const double x0 = (stress.start_height - law.residual_pressure) / law.atmospheric_pressure;
  const double x1 = (stress.height - law.residual_pressure) / law.atmospheric_pressure;
  // x^0.7 <= max(1, x): well below the line without a power
  if (std::max(e0, e1) < critical::intercept - critical::slope * std::max({1.0, x0, x1}))
    return false;
  const auto line = [](double x) {
    return critical::intercept - critical::slope * std::pow(std::max(x, 0.0), critical::exponent);
  };
  return (e0 < line(x0)) != (e1 < line(x1));
}

inline double dilation_flow(const Pdmy03& law, double beyond, double strain, double height) {
  constexpr double largest = 5e4;
  const auto& d = law.dilation;
  const double flow =
      beyond * beyond * (d[0] + std::pow(strain, d[1])) * std::pow(height / law.atmospheric_pressure, -d[2]);
  return std::min(flow, largest);
}

/// cos(theta) between the stress and its change, both as ratios.
inline double loading_cosine(const FlowStress& stress) {
  const Deviator3 change = (1.0 / stress.height) * stress.trial - (1.0 / stress.start_height) * stress.start;
  const double lengths = std::sqrt(dot(stress.start, stress.start) * dot(change, change));
  return lengths > 0.0 ? dot(stress.start, change) / lengths : 1.0;
}

inline double contraction_flow(const Pdmy03& law, double ratio, double total, double height, double factor) {
  const auto& c = law.contraction;
  const double pressure = std::max(0.1, std::pow(height / law.atmospheric_pressure, c[2]));
  return -(ratio - 1.0) * (ratio - 1.0) * (c[0] + total * c[1]) * pressure * factor;
}

/// P'' of one part of an increment; moves the perfectly plastic zone.
inline double volumetric_flow(const Pdmy03& law, const Pdmy03Memory& memory, const IncrementStart& start,
                              const FlowStress& stress, const FlowStrain& strain) {
  using Place = pdmy03_state::Place;
  const double to_ratio = std::sqrt(1.5) / stress.height;
  const double relative = norm(stress.contact) * to_ratio / law.transformation_ratio;
  const double start_ratio = norm(stress.start) * std::sqrt(1.5) / stress.start_height;
  double flow = 0.0;
  if (relative >= 1.0 && norm(stress.trial) * to_ratio >= start_ratio &&
      dot(stress.start, stress.trial) >= 0.0) {
    dilate(law, memory, start, strain);
    if (memory[Place::zone] == pdmy03_zone::dilating)
      flow = dilation_flow(law, relative - 1.0, memory[Place::dilation], stress.height);
  } else {
    flow = contraction_flow(law, relative * loading_cosine(stress), memory[Place::dilation_total],
                            stress.height, start.cyclic_factor);
    double& zone = memory[Place::zone];
    zone = std::min(zone, pdmy03_zone::left_dilation);
    if (zone != pdmy03_zone::never_reached)
      translate_zone(law, memory, start, strain.end);
  }
  return crosses_critical_state(law, stress) ? 0.0 : flow;
}

} // namespace tremolo::materials
