#pragma once

#include "materials/elasticity.hpp"
#include "materials/objective_rate.hpp"
#include "materials/points.hpp"

#include <cstddef>

namespace tremolo::materials {

/// sigma <- Q sigma Q^T + C : d_eps for points [begin, end): the whole step of an elastic law, the trial
/// stress of a plastic one. Arrays must not overlap.
inline void elastic_trial(const Elasticity& elastic, const Points& points, std::size_t begin,
                          std::size_t end) {
  const double lame = elastic.lame();
  const double shear = elastic.shear_modulus();
  double* __restrict sxx = points.sxx;
  double* __restrict syy = points.syy;
  double* __restrict szz = points.szz;
  double* __restrict sxy = points.sxy;
  const double* __restrict dexx = points.dexx;
  const double* __restrict deyy = points.deyy;
  const double* __restrict dgxy = points.dgxy;
  const double* __restrict dwxy = points.dwxy;
  for (std::size_t i = begin; i < end; ++i) {
    const InPlaneStress carried = rotated({sxx[i], syy[i], sxy[i]}, dwxy[i]);
    const double pressure = lame * (dexx[i] + deyy[i]);
    sxx[i] = carried.xx + pressure + 2.0 * shear * dexx[i];
    syy[i] = carried.yy + pressure + 2.0 * shear * deyy[i];
    szz[i] += pressure;
    sxy[i] = carried.xy + shear * dgxy[i];
  }
}

} // namespace tremolo::materials
