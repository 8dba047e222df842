#pragma once

#include "materials/elastic/elasticity.hpp"
#include "materials/law/parameter.hpp"

#include <array>
#include <vector>

namespace tremolo::materials {

/// The elastic constants as files give them: the density and two of the others.
inline constexpr std::array elastic_constants = {
    Parameter{.name = "density", .unit = "kg/m3", .meaning = "mass density", .range = above_zero},
    Parameter{.name = "young",
              .unit = "Pa",
              .meaning = "Young's modulus",
              .range = above_zero,
              .otherwise = "`vs`",
              .remark = "Together with `poisson`."},
    Parameter{.name = "poisson",
              .unit = "1",
              .meaning = "Poisson's ratio",
              .range = {.low = -1.0, .high = 0.5, .low_open = true, .high_open = true},
              .otherwise = "`vs` and `vp`",
              .remark = "Together with `young` or `vs`."},
    Parameter{.name = "vs",
              .unit = "m/s",
              .meaning = "speed of shear waves",
              .range = above_zero,
              .otherwise = "`young`",
              .remark = "Together with `vp` or `poisson`."},
    Parameter{.name = "vp",
              .unit = "m/s",
              .meaning = "speed of compression waves",
              .range = above_zero,
              .otherwise = "`poisson`",
              .remark = "Above sqrt(4/3) `vs`; together with `vs`."}};

/// The elastic constants, with which every law's list of parameters begins.
inline std::vector<ParameterValue> elastic_parameters(const Elasticity& elastic) {
  return {report(elastic_constants[0], elastic.density),
          report(elastic_constants[1], elastic.young),
          report(elastic_constants[2], elastic.poisson),
          {"shear_modulus", elastic.shear_modulus(), "Pa", "G", "E/(2 (1 + nu))"},
          {"bulk_modulus", elastic.bulk_modulus(), "Pa", "K", "E/(3 (1 - 2 nu))"}};
}

} // namespace tremolo::materials
