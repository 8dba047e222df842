#pragma once

// Vs of layered ground at random (Toro 1995, Probabilistic models of site velocity profiles for generic and
// site-specific ground-motion amplification studies, Brookhaven National Laboratory, Technical Report
// 779574). From the surface down,
//
//     V_i = V_i,0 exp(sigma_ln Z_i),   Z_1 = eps_1,   Z_i = rho Z_(i-1) + sqrt(1 - rho^2) eps_i,
//
// with standard normal eps_i. The correlation of neighbouring layers grows with depth and falls with their
// distance,
//
//     rho(h, t) = (1 - rho_d) rho_t + rho_d,   rho_t = rho_0 exp(-t/delta),
//     rho_d = rho_200 ((h + h_0)/(200 m + h_0))^b above 200 m, rho_200 below,
//
// h the mean depth and t the difference of the depths of their middles.

#include "base/random/variates.hpp"
#include "scene/choices.hpp"

#include <vector>

namespace tremolo::scene {

/// Standard deviation and correlation of ln Vs.
struct ToroModel {
  double sigma_ln = 0.0; ///< of ln Vs, 1
  double rho_0 = 0.0;    ///< 1, in [0, 1]
  double delta = 0.0;    ///< m, > 0
  double rho_200 = 0.0;  ///< 1, in [0, 1]
  double h_0 = 0.0;      ///< m, >= 0
  double b = 0.0;        ///< 1, >= 0
};

/// The parameters that Toro (1995) gives for a class of sites.
ToroModel toro_model(ToroClass of);

/// rho of neighbouring layers.
/// @param upper, lower  depths of their middles, m
double correlation(const ToroModel& model, double upper, double lower);

/// Z of each layer. A draw eps_i that would take Z_i out of [-limit, limit] is made again.
/// @param middles  depths of the layers' middles, from the surface down, m
/// @param limit    > 0; infinite: Z is normal
std::vector<double> standard_variates(const ToroModel& model, const std::vector<double>& middles,
                                      double limit, NormalVariates normal);

} // namespace tremolo::scene
