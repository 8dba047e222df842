#pragma once

#include "materials/elastic/elasticity.hpp"
#include "materials/law/parameter_value.hpp"

#include <vector>

namespace tremolo::materials {

/// The elastic constants, with which every law's list of parameters begins.
inline std::vector<ParameterValue> elastic_parameters(const Elasticity& elastic) {
  return {{"density", elastic.density, "kg/m3", "mass per volume", "given"},
          {"young", elastic.young, "Pa", "Young's modulus E", "given"},
          {"poisson", elastic.poisson, "1", "Poisson's ratio nu", "given"},
          {"shear_modulus", elastic.shear_modulus(), "Pa", "G", "E/(2 (1 + nu))"},
          {"bulk_modulus", elastic.bulk_modulus(), "Pa", "K", "E/(3 (1 - 2 nu))"}};
}

} // namespace tremolo::materials
