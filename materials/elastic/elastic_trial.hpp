#pragma once

#include "materials/elastic/elasticity.hpp"
#include "materials/law/points.hpp"
#include "materials/tensor/independent_loop.hpp"
#include "materials/tensor/objective_rate.hpp"

#include <cstddef>

namespace tremolo::materials {

/// Adds C : (d_eps_zz e_z e_z) to the stresses of points [begin, end). A pass of its own, so that plane
/// strain pays nothing for it. Arrays must not overlap.
inline void out_of_plane_trial(const Elasticity& elastic, const Points& points, std::size_t begin,
                               std::size_t end) {
  const double lame = elastic.lame();
  const double modulus = elastic.p_modulus();
  double* __restrict sxx = points.sxx;
  double* __restrict syy = points.syy;
  double* __restrict szz = points.szz;
  const double* __restrict dezz = points.dezz;
  TREMOLO_INDEPENDENT_LOOP
  for (std::size_t i = begin; i < end; ++i) {
    sxx[i] += lame * dezz[i];
    syy[i] += lame * dezz[i];
    szz[i] += modulus * dezz[i];
  }
}

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
  TREMOLO_INDEPENDENT_LOOP
  for (std::size_t i = begin; i < end; ++i) {
    const InPlaneStress carried = rotated({sxx[i], syy[i], sxy[i]}, dwxy[i]);
    const double pressure = lame * (dexx[i] + deyy[i]);
    sxx[i] = carried.xx + pressure + 2.0 * shear * dexx[i];
    syy[i] = carried.yy + pressure + 2.0 * shear * deyy[i];
    szz[i] += pressure;
    sxy[i] = carried.xy + shear * dgxy[i];
  }
  if (points.dezz != nullptr)
    out_of_plane_trial(elastic, points, begin, end);
}

/// Strain increment out of plane of point i: 0 in plane strain.
inline double out_of_plane_strain(const Points& points, std::size_t i) {
  return points.dezz == nullptr ? 0.0 : points.dezz[i];
}

} // namespace tremolo::materials
