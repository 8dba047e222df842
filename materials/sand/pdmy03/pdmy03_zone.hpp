#pragma once

// The perfectly plastic zone. Each crossing of the phase transformation line enters the zone, a sphere of
// strain deviators in which shear is perfectly plastic; leaving it starts a dilation. Its size grows with the
// strain under dilation, which is how cyclic mobility adds strain cycle by cycle (Khosravifar et al. 2018;
// Yang et al. 2003). Four points at a time, some of which take part.

#include "materials/sand/pdmy03/pdmy03_state.hpp"

namespace tremolo::materials {

using Pdmy03States = Pdmy03StateOf<Lanes>;
using Deviators3 = Deviator3Of<Lanes>;

template <typename Real>
Real octahedral_strain(const Deviator3Of<Real>& e) {
  return 2.0 / std::sqrt(3.0) * norm(e);
}

/// State at the start of an increment that the flow rule keeps during its parts.
struct IncrementStart {
  Deviators3 increment; ///< deviator of the whole strain increment
  Lanes damage;         ///< ((p_max - p')/(p_max + p_res))^(1/4)
  Lanes cyclic_factor;  ///< C
  LaneMask turned;      ///< against the direction in which the last dilation began
};

/// Strain of a part of an increment.
struct FlowStrain {
  Deviators3 end; ///< total strain deviator at its end
  Lanes length;   ///< octahedral, of the part
};

/// The zone follows the strain after a reversal.
inline void translate_zone(const Pdmy03& law, Pdmy03States& state, const LaneMask& which,
                           const IncrementStart& start, const Deviators3& strain) {
  const LaneMask follows = which & start.turned;
  if (law.liquefaction_1 == 0.0 || law.liquefaction_2 == 0.0 || !any(follows))
    return;
  const Lanes moved = start.damage * law.liquefaction_2 * octahedral_strain(strain - state.pivot);
  state.zone_translation = choose(follows, larger(state.zone_translation, moved), state.zone_translation);
}

/// Points that have come above the phase transformation line: through the zone, or still in it.
inline void enter_zone(const Pdmy03& law, Pdmy03States& state, const LaneMask& which,
                       const IncrementStart& start, const Deviators3& strain) {
  state.damage = choose(which, start.damage, state.damage); // and stays while it dilates
  const Lanes size = 0.5 * (state.zone_translation + state.dilation_total);
  state.zone_size = choose(which, size, state.zone_size);
  const LaneMask again = which & ((state.zone == pdmy03_zone::left_dilation) |
                                  ((state.zone == pdmy03_zone::inside) & start.turned));
  if (any(again)) {
    const Deviators3 arm = state.pivot - state.zone_centre;
    const Lanes length = octahedral_strain(arm);
    const Lanes reach = size - state.zone_translation;
    const Deviators3 behind = state.pivot - (reach / length) * arm;
    state.zone_centre = choose(again, choose(length > 0.0, behind, state.pivot), state.zone_centre);
  }
  const LaneMask crossed = which & (octahedral_strain(strain - state.zone_centre) > size);
  translate_zone(law, state, which & ~crossed, start, strain);
  state.zone =
      choose(which, choose(crossed, all(pdmy03_zone::dilating), all(pdmy03_zone::inside)), state.zone);
  state.dilation = choose(crossed, Lanes{}, state.dilation);
  state.zone_translation = choose(crossed, Lanes{}, state.zone_translation);
  state.pivot = choose(crossed, strain, state.pivot);
  state.pivot_direction = choose(crossed, start.increment, state.pivot_direction);
}

/// One more part of an increment above the phase transformation line.
inline void dilate(const Pdmy03& law, Pdmy03States& state, const LaneMask& which, const IncrementStart& start,
                   const FlowStrain& strain) {
  const LaneMask already = which & (state.zone == pdmy03_zone::dilating);
  const LaneMask enters = which & ~already;
  state.dilation = choose(already, state.dilation + strain.length, state.dilation);
  if (law.liquefaction_1 == 0.0) { // no zone
    state.dilation = choose(enters & start.turned, Lanes{}, state.dilation);
    state.zone = choose(which, all(pdmy03_zone::dilating), state.zone);
    return;
  }
  state.pivot = choose(already, strain.end, state.pivot);
  const Lanes total = state.dilation_total + state.damage * law.liquefaction_1 * strain.length;
  state.dilation_total = choose(already, total, state.dilation_total);
  if (any(enters))
    enter_zone(law, state, enters, start, strain.end);
}

/// One more part of an increment below the line.
inline void leave_dilation(const Pdmy03& law, Pdmy03States& state, const LaneMask& which,
                           const IncrementStart& start, const FlowStrain& strain) {
  state.zone = choose(which, smaller(state.zone, all(pdmy03_zone::left_dilation)), state.zone);
  translate_zone(law, state, which & (state.zone != pdmy03_zone::never_reached), start, strain.end);
}

} // namespace tremolo::materials
