#include "app/soiltest/soiltest_lines.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

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

} // namespace

Invariants invariants(const materials::Law& law, const soiltest::History& history) {
  const auto& xx = history.column("sig_xx");
  const auto& yy = history.column("sig_yy");
  const auto& zz = history.column("sig_zz");
  const auto& xy = history.column("sig_xy");
  const bool in_plane = materials::traits(law).in_plane;
  Invariants values;
  for (std::size_t i = 0; i < history.rows(); ++i) {
    if (in_plane) {
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
  std::vector<StressLine> lines;
  for (const auto& [name, q_of_p] : materials::strength_lines(law))
    lines.push_back(line(std::string(name), largest_p, q_of_p));
  return lines;
}

} // namespace tremolo::app
