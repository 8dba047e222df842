#include "app/soiltest/soiltest_lines.hpp"

#include "materials/sand/pm4sand/pm4sand_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <variant>

namespace tremolo::app {
namespace {

StressLine line(std::string name, double largest_p, const std::function<double(double)>& q_of_p) {
  constexpr int intervals = 100;
  StressLine made{std::move(name), {}, {}};
  for (int i = 0; i <= intervals; ++i) {
    made.p.push_back(largest_p * i / intervals);
    made.q.push_back(q_of_p(made.p.back()));
  }
  return made;
}

std::vector<StressLine> lines(const materials::Pm4Sand& law, double largest_p) {
  const auto at = [&law](double p) {
    return materials::pm4::surfaces(law, std::max(p, law.p_A / 200.0), 0.0);
  };
  const auto bounding = [&](double p) { return p * at(p).M_b; };
  const auto dilation = [&](double p) { return p * at(p).M_d; };
  return {line("critical_state", largest_p, [&](double p) { return law.M * p; }),
          line("bounding", largest_p, bounding), line("dilation", largest_p, dilation)};
}

std::vector<StressLine> lines(const materials::Pdmy03& law, double largest_p) {
  const auto cone = [&](double slope) {
    return [slope, apex = law.residual_pressure](double p) { return slope * (p + apex); };
  };
  return {line("phase_transformation", largest_p, cone(law.transformation_ratio)),
          line("failure", largest_p, cone(law.ratio.at(law.surfaces)))};
}

/// sigma_1 - sigma_3 = 2 c cos(phi) + 2 p sin(phi), where sigma_zz lies between them.
std::vector<StressLine> lines(const materials::MohrCoulomb& law, double largest_p) {
  return {line("failure", largest_p, [&](double p) {
    return 2.0 * (law.cohesion_peak * std::cos(law.friction_peak) + p * std::sin(law.friction_peak));
  })};
}

std::vector<StressLine> lines(const materials::DruckerPrager& law, double largest_p) {
  const auto cone = materials::cone(law);
  return {line("failure", largest_p,
               [cone](double p) { return std::numbers::sqrt3 * (cone.strength + cone.slope * p); })};
}

std::vector<StressLine> lines(const materials::MultiYieldClay& law, double largest_p) {
  return {line("failure", largest_p, [&](double) { return std::numbers::sqrt3 * law.undrained_strength; })};
}

template <class Other>
std::vector<StressLine> lines(const Other& /*law*/, double /*largest_p*/) {
  return {};
}

} // namespace

bool in_plane(const materials::Law& law) {
  return std::holds_alternative<materials::Pm4Sand>(law) ||
         std::holds_alternative<materials::MohrCoulomb>(law);
}

Invariants invariants(const materials::Law& law, const soiltest::History& history) {
  const auto& xx = history.column("sig_xx");
  const auto& yy = history.column("sig_yy");
  const auto& zz = history.column("sig_zz");
  const auto& xy = history.column("sig_xy");
  Invariants values;
  for (std::size_t i = 0; i < history.rows(); ++i) {
    if (in_plane(law)) {
      values.p.push_back(-0.5 * (xx[i] + yy[i]));
      values.q.push_back(2.0 * std::hypot(0.5 * (xx[i] - yy[i]), xy[i]));
      continue;
    }
    const double mean = (xx[i] + yy[i] + zz[i]) / 3.0;
    const double squares = std::pow(xx[i] - mean, 2) + std::pow(yy[i] - mean, 2) + std::pow(zz[i] - mean, 2);
    values.p.push_back(-mean);
    values.q.push_back(std::sqrt(1.5 * squares + 3.0 * xy[i] * xy[i]));
  }
  return values;
}

std::vector<StressLine> stress_lines(const materials::Law& law, double largest_p) {
  return std::visit([&](const auto& one) { return lines(one, largest_p); }, law);
}

} // namespace tremolo::app
