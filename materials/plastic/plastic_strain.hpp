#pragma once

#include "materials/law/state_variable.hpp"

#include <array>

namespace tremolo::materials {

/// The state block of laws that remember how far they have yielded.
inline constexpr std::array plastic_strain_state = {StateVariable{
    "equivalent_plastic_strain", "1", "int sqrt(2/3 de:de) of the deviatoric plastic strain", 0.0}};

} // namespace tremolo::materials
