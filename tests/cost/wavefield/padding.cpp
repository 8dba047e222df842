// What the length of the synthesis window costs and brings: largest error of the surface velocity against the
// window that is chosen without being asked, over CPU time, as CSV on standard output.

#include "wavefield/layers/layered_field.hpp"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace tremolo::wavefield;

constexpr TimeGrid times{0.0, 0.005, 801}; // 4 s

struct Ground {
  std::string name;
  LayeredHalfSpace profile;
  double angle_deg = 0.0;
};

std::vector<Ground> grounds() {
  const auto layered = [](DampingModel model) {
    const double on = model == DampingModel::none ? 0.0 : 1.0;
    LayeredHalfSpace profile{
        .layers = {{6.0, 1700.0, 120.0, 300.0, 0.05 * on}, {14.0, 1850.0, 220.0, 500.0, 0.03 * on}},
        .half_space = {2100.0, 500.0, 1000.0},
        .half_space_damping = 0.01 * on,
        .damping = {model, 3.0}};
    return profile;
  };
  return {{"elastic layers, SV 20 degrees", layered(DampingModel::none), 20.0},
          {"Kelvin-Voigt layers, SV 20 degrees", layered(DampingModel::kelvin_voigt), 20.0},
          {"hysteretic layers, SV 20 degrees", layered(DampingModel::hysteretic), 20.0},
          {"half-space, SV 40 degrees, post-critical", {.half_space = {1700.0, 95.9, 173.4}}, 40.0}};
}

/// Surface velocity with a window, and the CPU time it took, s.
struct Result {
  std::vector<double> vx;
  double cpu = 0.0;
};

Result surface(const Ground& ground, const SynthesisOptions& options) {
  const Incidence incidence{WaveType::SV, ground.angle_deg * std::numbers::pi / 180.0, 0.0, -20.0};
  const LayeredField field(ground.profile, incidence, 0.0, ricker(3.0, 1.0, 0.1), options);
  // Many levels, as a side has; the last one is the surface.
  constexpr int levels = 80;
  std::vector<Point> points;
  for (int i = 0; i <= levels; ++i)
    points.push_back({0.0, -20.0 + 20.0 * i / levels});
  const std::clock_t start = std::clock();
  auto histories = field.sample(points, times, Part::total, {.displacement = false, .strain = false});
  return {std::move(histories.back().vx), static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC};
}

double error(const std::vector<double>& values, const std::vector<double>& exact) {
  double largest = 0.0;
  double peak = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    largest = std::max(largest, std::abs(values[i] - exact[i]));
    peak = std::max(peak, std::abs(exact[i]));
  }
  return largest / peak;
}

} // namespace

int main() {
  std::printf("ground,padding,error,cpu_s\n");
  for (const Ground& ground : grounds()) {
    constexpr double longest = 512.0;
    const Result exact = surface(ground, {.padding = longest});
    for (const double padding : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0}) {
      const Result result = surface(ground, {.padding = padding});
      std::printf("\"%s\",%g,%.3e,%.4f\n", ground.name.c_str(), padding, error(result.vx, exact.vx),
                  result.cpu);
    }
    const Result chosen = surface(ground, {});
    std::printf("\"%s\",0,%.3e,%.4f\n", ground.name.c_str(), error(chosen.vx, exact.vx), chosen.cpu);
  }
}
