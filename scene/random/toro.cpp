#include "scene/random/toro.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

ToroModel toro_model(ToroClass of) {
  using enum ToroClass;
  switch (of) {
  case geomatrix_ab:
    return {.sigma_ln = 0.46, .rho_0 = 0.96, .delta = 13.1, .rho_200 = 0.96, .h_0 = 0.0, .b = 0.095};
  case geomatrix_cd:
    return {.sigma_ln = 0.38, .rho_0 = 0.99, .delta = 8.0, .rho_200 = 1.00, .h_0 = 0.0, .b = 0.160};
  case usgs_ab:
    return {.sigma_ln = 0.35, .rho_0 = 0.95, .delta = 4.2, .rho_200 = 1.00, .h_0 = 0.0, .b = 0.138};
  case usgs_cd:
    return {.sigma_ln = 0.36, .rho_0 = 0.99, .delta = 3.9, .rho_200 = 1.00, .h_0 = 0.0, .b = 0.293};
  case usgs_a:
    return {.sigma_ln = 0.36, .rho_0 = 0.95, .delta = 3.4, .rho_200 = 0.42, .h_0 = 0.0, .b = 0.063};
  case usgs_b:
    return {.sigma_ln = 0.27, .rho_0 = 0.97, .delta = 3.8, .rho_200 = 1.00, .h_0 = 0.0, .b = 0.293};
  case usgs_c:
    return {.sigma_ln = 0.31, .rho_0 = 0.99, .delta = 3.9, .rho_200 = 0.98, .h_0 = 0.0, .b = 0.344};
  case usgs_d:
    return {.sigma_ln = 0.37, .rho_0 = 0.00, .delta = 5.0, .rho_200 = 0.50, .h_0 = 0.0, .b = 0.744};
  }
  return {};
}

double correlation(const ToroModel& model, double upper, double lower) {
  constexpr double deep = 200.0; // m
  const double depth = std::min(0.5 * (upper + lower), deep);
  const double of_depth = model.rho_200 * std::pow((depth + model.h_0) / (deep + model.h_0), model.b);
  const double of_distance = model.rho_0 * std::exp(-(lower - upper) / model.delta);
  return (1.0 - of_depth) * of_distance + of_depth;
}

std::vector<double> standard_variates(const ToroModel& model, const std::vector<double>& middles,
                                      double limit, NormalVariates normal) {
  std::vector<double> variates;
  for (std::size_t i = 0; i < middles.size(); ++i) {
    const double rho = i == 0 ? 0.0 : correlation(model, middles[i - 1], middles[i]);
    const double mean = i == 0 ? 0.0 : rho * variates.back();
    const double rest = std::sqrt(1.0 - rho * rho);
    double z = 0.0;
    do
      z = mean + rest * normal();
    while (std::abs(z) > limit);
    variates.push_back(z);
  }
  return variates;
}

} // namespace tremolo::scene
