// Error of the column under an SV wave at 15 degrees and the CPU time that it takes, over elements, steps and
// the tolerance of its steps' iteration. Each of the three is varied while the others stay at what a case
// gets, and compared with a run at the last, finest of its values, the root of the sum of squares of the
// difference of the surface's velocity vector over that of the velocity. Prints CSV.

#include "freefield/marched/marched_column.hpp"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <vector>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;

constexpr double angle = 15.0 * std::numbers::pi / 180.0;
constexpr double interval = 0.01; // s, between samples

struct Ground {
  const char* name;
  Profile profile;
  double peak;     ///< of the incident wave, m/s
  double duration; ///< s
};

/// 20 m of MKZ soil.
Ground mkz() {
  Ground ground{"MKZ", {.half_space = Elasticity::from_wave_speeds(2400.0, 760.0, 1400.0)}, 0.25, 2.0};
  for (const double vs : {150.0, 250.0}) {
    const tremolo::materials::MasingShear law{.elastic = Elasticity::from_wave_speeds(1900.0, vs, 2.0 * vs),
                                              .reference_strain = 6e-4,
                                              .exponent = 0.919};
    ground.profile.layers.push_back(layer_of(10.0, law));
  }
  return ground;
}

/// 20 m of cohesive soil, which slips.
Ground cohesive() {
  Ground ground{"cohesive", {.half_space = Elasticity::from_wave_speeds(2400.0, 760.0, 1400.0)}, 0.25, 2.0};
  ground.profile.gravity = 9.81;
  const auto layer = [](double thickness, double density, double vs, double poisson, double strength) {
    Elasticity soil{
        .density = density, .young = 2.0 * density * vs * vs * (1.0 + poisson), .poisson = poisson};
    soil.at_rest = 0.9;
    return layer_of(thickness, tremolo::materials::DruckerPrager{.elastic = soil, .cohesion = strength});
  };
  ground.profile.layers = {layer(6.0, 1800.0, 150.0, 0.3, 40e3), layer(14.0, 2000.0, 250.0, 0.35, 75e3)};
  return ground;
}

/// 10 m of saturated sand that liquefies.
Ground sand() {
  Ground ground{"PM4Sand", {.half_space = Elasticity::from_wave_speeds(2200.0, 760.0, 1900.0)}, 0.1, 2.0};
  ground.profile.gravity = 9.81;
  ground.profile.water = WaterTable{0.0, {}};
  const tremolo::materials::PoreSpace pores{0.42, 2650.0, 1e-4, tremolo::materials::Drainage::coupled};
  Layer layer =
      layer_of(10.0, tremolo::materials::pm4sand({.density = tremolo::materials::saturated_density(pores, {}),
                                                  .relative_density = 0.55,
                                                  .G_o = 677.0,
                                                  .h_po = 0.4}));
  layer.pores = pores;
  layer.damping_ratio = 0.005;
  ground.profile.layers = {layer};
  return ground;
}

/// Eight half-waves of 3 Hz under a half-sine.
InputVelocity wave(double peak) {
  return [peak](double t) {
    const double since = t - 0.05;
    if (since <= 0.0 || since >= 1.3)
      return Velocity{};
    const double v = peak * std::pow(std::sin(since * std::numbers::pi / 1.3), 2) *
                     std::sin(6.0 * std::numbers::pi * (since - 0.65) + 0.7);
    return Velocity{v * std::cos(angle), -v * std::sin(angle)};
  };
}

struct Choice {
  double element = 0.25;  ///< m
  double share = 0.9;     ///< of the limit of the step
  double tolerance = 0.1; ///< of the iteration
};

struct Run {
  std::vector<double> motion; ///< vx and vy of the surface, m/s
  double cpu = 0.0;           ///< s
  double step = 0.0;          ///< s
  double calls = 0.0;
  long unconverged = 0;
};

Run run(const Ground& ground, const Choice& choice) {
  const double slowness = std::sin(angle) / ground.profile.half_space.s_wave_speed();
  const Damping damping = KelvinVoigtDamping{5.0};
  const double longest =
      choice.share * marched_step_limit(ground.profile, choice.element, slowness, damping, 2.0);
  MarchedSettings settings{.max_element_size = choice.element,
                           .time_step = interval / std::ceil(interval / longest),
                           .slowness_x = slowness,
                           .damping = damping,
                           .tolerance = choice.tolerance};
  Run result;
  const std::clock_t begin = std::clock();
  MarchedColumn column(ground.profile, settings, wave(ground.peak));
  const double surface = 0.0;
  for (int i = 1; i * interval <= ground.duration + 1e-9; ++i) {
    while (column.time() < i * interval - 0.5 * settings.time_step)
      column.step();
    ColumnSample s;
    column.sample({&surface, 1}, {&s, 1});
    result.motion.push_back(s.vx);
    result.motion.push_back(s.vy);
  }
  result.cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  result.step = settings.time_step;
  result.calls = column.evaluations_per_step();
  result.unconverged = column.unconverged_steps();
  return result;
}

double difference(const Run& a, const Run& b) {
  double squares = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.motion.size(); ++i) {
    squares += std::pow(a.motion[i] - b.motion[i], 2);
    size += std::pow(b.motion[i], 2);
  }
  return std::sqrt(squares / size);
}

void study(const Ground& ground, const char* varied, const std::vector<Choice>& choices) {
  const Run finest = run(ground, choices.back());
  for (std::size_t i = 0; i + 1 < choices.size(); ++i) {
    const Run r = run(ground, choices[i]);
    std::printf("%s,%s,%g,%.3g,%g,%.2e,%.3f,%.2f,%ld\n", ground.name, varied, choices[i].element, r.step,
                choices[i].tolerance, difference(r, finest), r.cpu, r.calls, r.unconverged);
    std::fflush(stdout);
  }
}

} // namespace

int main() {
  std::printf("ground,varied,element_m,step_s,tolerance,error,cpu_s,calls_a_step,unconverged\n");
  for (const Ground& ground : {mkz(), cohesive(), sand()}) {
    study(ground, "element",
          {{.element = 2.0}, {.element = 1.0}, {.element = 0.5}, {.element = 0.25}, {.element = 0.125}});
    study(ground, "step", {{.share = 0.9}, {.share = 0.45}, {.share = 0.225}, {.share = 0.1125}});
    study(ground, "tolerance",
          {{.tolerance = 1.0},
           {.tolerance = 0.1},
           {.tolerance = 1e-2},
           {.tolerance = 1e-3},
           {.tolerance = 1e-4},
           {.tolerance = 1e-6},
           {.tolerance = 1e-10}});
  }
}
