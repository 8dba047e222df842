// Response of the PRENOLIN profile P1 (Regnier et al. 2016, Bull. Seism. Soc. Am. 106(5), 2112-2135): 20 m,
// 2000 kg/m3, Vs 300 m/s, Vp 700 m/s, hyperbolic soil with reference strain 3.65e-4, on a rigid base that
// moves as the record in the borehole does (within motion, taken as m/s). Reads the record from the file
// named, two columns, time and velocity; prints three tables: histories, peak profile, loop at the largest
// strain.

#include "freefield/twophase/two_phase_column.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::MasingShear;

constexpr double height = 20.0;
constexpr double duration = 5.0;
constexpr double element = 0.25;

InputVelocity record(const std::string& path) {
  std::ifstream file(path);
  std::vector<double> times;
  std::vector<double> values;
  for (double t = 0.0, v = 0.0; file >> t >> v;) {
    times.push_back(t);
    values.push_back(v);
  }
  if (times.size() < 2) {
    throw std::runtime_error("no motion in " + path);
  }
  return [times, values](double t) {
    if (t <= times.front() || t >= times.back()) {
      return Velocity{};
    }
    const auto i = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin());
    const double share = (t - times[i - 1]) / (times[i] - times[i - 1]);
    return Velocity{std::lerp(values[i - 1], values[i], share), 0.0};
  };
}

TwoPhaseColumn column(bool linear, const InputVelocity& motion) {
  const Elasticity soil = Elasticity::from_wave_speeds(2000.0, 300.0, 700.0);
  const Layer layer = linear ? Layer{height, soil}
                             : layer_of(height, MasingShear{.elastic = soil, .reference_strain = 3.65e-4});
  return {{.layers = {layer}, .half_space = soil},
          {.max_element_size = element, .time_step = 2.5e-4, .base = BaseKind::rigid},
          motion};
}

void respond(const char* name, TwoPhaseColumn soil) {
  const auto elements = static_cast<int>(height / element);
  std::vector<double> levels;
  levels.reserve(static_cast<std::size_t>(elements) + 2);
  for (int i = 0; i < elements; ++i)
    levels.push_back(-height + (i + 0.5) * element);
  levels.push_back(-height);
  levels.push_back(0.0);
  std::vector<ColumnSample> s(levels.size());
  std::vector<double> peak(levels.size());
  std::vector<std::vector<ColumnSample>> history;
  while (soil.time() < duration) {
    soil.step();
    soil.sample(levels, s);
    for (std::size_t i = 0; i + 2 < levels.size(); ++i) {
      peak[i] = std::max(peak[i], std::abs(s[i].gxy));
    }
    history.push_back(s);
  }
  const auto weakest = static_cast<std::size_t>(std::max_element(peak.begin(), peak.end()) - peak.begin());
  for (std::size_t n = 0; n < history.size(); n += 4) {
    const auto& now = history[n];
    std::printf("history,%s,%.5f,%.6e,%.6e,%.6e,%.6e,%.6e\n", name,
                soil.time_step() * static_cast<double>(n + 1), now[levels.size() - 2].vx_rate,
                now.back().vx_rate, now.back().vx, now[weakest].gxy, now[weakest].sxy);
  }
  for (std::size_t i = 0; i + 2 < levels.size(); ++i) {
    std::printf("peak,%s,%.4f,%.6e\n", name, -levels[i], peak[i]);
  }
}

} // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    throw std::runtime_error("usage: cost_fe_prenolin MOTION");
  }
  const InputVelocity motion = record(argv[1]);
  respond("linear", column(true, motion));
  respond("hyperbolic", column(false, motion));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "cost_fe_prenolin: %s\n", error.what());
  return 1;
}
