// Ordinary scenes under odd circumstances: nothing comes in, too much comes in, soil stands exactly on
// nodes, most cells are empty, gravity points up, metres are ten or a tenth of them, a run is cut in two.

#include "free_block.hpp"
#include "tests/support/saved_state.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

constexpr double degree = std::numbers::pi / 180.0;

PlaneWave oblique_wave(double depth) {
  PlaneWave wave;
  wave.angle = 15.0 * degree;
  wave.y_reference = -depth;
  wave.arrival = 0.3;
  return wave;
}

Scene shaken_box(int threads, const PlaneWave& wave, const Spec& spec) {
  Spec mine = spec;
  mine.threads = threads;
  auto domain = std::make_unique<Domain>(mine);
  FreeFieldSource source = plane_wave_source(*domain, wave, true);
  return {std::move(domain), std::move(source)};
}

double fastest(const Domain& domain) {
  double speed = 0.0;
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      speed = std::max(speed, std::hypot(p.vx[k], p.vy[k]));
  return speed;
}

TEST(Robustness, NothingComesInNothingMoves) {
  PlaneWave silence = oblique_wave(5.0);
  silence.amplitude = 0.0;
  const Scene end =
      run_monitored([&](int threads) { return shaken_box(threads, silence, elastic_box(10.0, 5.0, 1.0)); },
                    {.speed = 1e-300}, after_steps(1000));
  exactly("largest speed", fastest(*end.domain), 0.0, "m/s");
  exactly("largest stress", largest_stress(*end.domain), 0.0, "Pa");
}

/// 2 g at 3 Hz, 1.04 m/s, in soil that yields.
TEST(Robustness, TwoG) {
  PlaneWave wave = oblique_wave(10.0);
  wave.repeat = 1.0;
  wave.amplitude = 2.0 * 9.81 / (2.0 * std::numbers::pi * 3.0);
  Spec spec = elastic_box(20.0, 10.0, 1.0);
  spec.soils = {{"soil", materials::MohrCoulomb{.elastic = {1700.0, 40e6, 0.28},
                                                .cohesion_peak = 20e3,
                                                .cohesion_residual = 5e3,
                                                .friction_peak = 35.0 * degree,
                                                .friction_residual = 28.0 * degree,
                                                .softening = 15.0}}};
  const Scene end = run_monitored([&](int threads) { return shaken_box(threads, wave, spec); },
                                  {.speed = 3.0 * wave.amplitude + 1.0}, at_time(10.0));
  reaches("plastic work", end.domain->energy.plastic, 1.0, "J/m");
}

TEST(Robustness, OneEightAndSixteenThreads) {
  std::vector<Particles> results;
  for (const int threads : {1, 8, 16}) {
    const Scene scene = shaken_box(threads, oblique_wave(40.0), elastic_box(5.0, 40.0, 1.0));
    Stepper stepper(*scene.domain, 0.0, scene.source);
    while (stepper.steps() < 100)
      stepper.step();
    results.push_back(scene.domain->sets.front());
  }
  expect_same_bits({results[0]}, {results[1]});
  expect_same_bits({results[0]}, {results[2]});
  exactly("difference of velocity", results[0].vx == results[2].vx ? 0.0 : 1.0, 0.0);
}

/// A wave in a block of 4 m whose particles have been moved by half their size to where places are exact, and
/// how far its energy rises.
void expect_a_calm_wave(const Spec& spec, double expected,
                        const std::function<bool(const Particles&, std::size_t)>& is_exact) {
  const auto make = [&spec](int threads) {
    return free_scene(spec, threads, [](Domain& domain) {
      for (Particles& p : domain.sets)
        for (std::size_t k = 0; k < p.size(); ++k) {
          p.x[k] += 0.25;
          p.y[k] += 0.25;
        }
      set_velocity(domain, [](double x, double y) {
        return Vector{0.01 * std::cos(std::numbers::pi * (x - 0.25) / 4.0),
                      0.01 * std::cos(std::numbers::pi * (y - 0.25) / 4.0)};
      });
    });
  };
  const Scene start = make(1);
  double exact = 0.0;
  for (const Particles& p : start.domain->sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      exact += is_exact(p, k);
  exactly("particles there", exact, expected);
  // Leapfrog: the mean of the kinetic energies half a step before and after belongs to the elastic one.
  double kinetic = 0.0;
  double elastic = 0.0;
  double first = 0.0;
  double highest = 0.0;
  run_monitored(make, {.speed = 0.05}, after_steps(2000), [&](Domain& d, const Stepper& s) {
    const double before = s.steps() == 1 ? d.energy.kinetic_start : kinetic;
    kinetic = d.energy.kinetic;
    const double energy = 0.5 * (before + kinetic) + elastic;
    elastic = d.energy.elastic;
    if (s.steps() == 1)
      first = energy;
    highest = std::max(highest, energy);
  });
  bounded("highest energy over that at the start", highest / first, 1.02);
}

bool is_whole(double cells) {
  return cells == std::round(cells);
}

TEST(Robustness, ParticlesExactlyOnNodes) {
  expect_a_calm_wave(elastic_box(4.0, 4.0, 1.0), 16.0,
                     [](const Particles& p, std::size_t k) { return is_whole(p.x[k]) && is_whole(p.y[k]); });
}

/// Cells of 1 m on the left, of 0.5 m on the right of x = 2 m.
TEST(Robustness, ParticlesExactlyOnHangingNodes) {
  Spec spec = elastic_box(4.0, 4.0, 1.0);
  spec.refine = {{{2.0, -4.0, 4.0, 0.0}, 1}};
  expect_a_calm_wave(
      spec, 4.0, [](const Particles& p, std::size_t k) { return p.x[k] == 2.0 && is_whole(p.y[k] + 0.5); });
}

/// The same motion in a box that is nearly empty, to the rounding of coordinates.
TEST(Robustness, NearlyAllCellsAreEmpty) {
  const auto make = [](double width, double height) {
    Spec spec = elastic_box(2.0, 2.0, 0.5);
    spec.box.x_max = width;
    spec.box.y_max = height;
    return free_scene(spec, 1, [](Domain& domain) {
      set_velocity(domain, [](double x, double y) { return Vector{3.0 + 0.01 * y, 0.2 * std::cos(x)}; });
    });
  };
  std::vector<Particles> results;
  double cells = 0.0;
  for (const double size : {2.0, 40.0}) {
    const Scene scene = make(size, size);
    Stepper stepper(*scene.domain, 0.0, scene.source);
    while (stepper.steps() < 2000)
      stepper.step();
    results.push_back(scene.domain->sets.front());
    cells = static_cast<double>(scene.domain->grid.size());
  }
  double difference = 0.0;
  for (std::size_t k = 0; k < results[0].size(); ++k)
    difference = std::max(difference, std::abs(results[0].vx[k] - results[1].vx[k]));
  reaches("share of empty cells", 1.0 - 16.0 / cells, 0.9);
  bounded("difference of velocity over the drift", difference / 3.0, 1e-12);
}

TEST(Robustness, GravityPointsUp) {
  const auto fall = [](double gravity) {
    Spec spec = elastic_box(2.0, 2.0, 0.5);
    spec.gravity = gravity;
    Scene end = run_monitored([&](int threads) { return free_scene(spec, threads, [](Domain&) {}); },
                              {.speed = 10.0}, at_time(1.0 - 1e-9));
    return end;
  };
  const Scene down = fall(9.81);
  const Scene up = fall(-9.81);
  const Particles& a = down.domain->sets.front();
  const Particles& b = up.domain->sets.front();
  double difference = 0.0;
  for (std::size_t id = 0; id < a.size(); ++id) {
    const std::size_t ka = a.index_of[id];
    const std::size_t kb = b.index_of[id];
    difference = std::max(difference, std::abs((a.y[ka] - a.y_initial[ka]) + (b.y[kb] - b.y_initial[kb])));
  }
  bounded("way up less way down", difference, 1e-9, "m");
}

/// Lengths and times times 0.1 and 10: the same velocities.
TEST(Robustness, MetresOrTenthsOrTens) {
  std::vector<Particles> results;
  for (const double scale : {1.0, 0.1, 10.0}) {
    PlaneWave wave = oblique_wave(10.0 * scale);
    wave.frequency /= scale;
    wave.arrival *= scale;
    const Scene scene = shaken_box(1, wave, elastic_box(20.0 * scale, 10.0 * scale, scale));
    Stepper stepper(*scene.domain, 0.0, scene.source);
    while (stepper.steps() < 400)
      stepper.step();
    results.push_back(scene.domain->sets.front());
  }
  double difference = 0.0;
  double largest = 0.0;
  const Particles& a = results[0];
  for (const Particles& b : results)
    for (std::size_t id = 0; id < a.size(); ++id) {
      const std::size_t ka = a.index_of[id];
      const std::size_t kb = b.index_of[id];
      largest = std::max(largest, std::abs(a.vx[ka]));
      difference = std::max({difference, std::abs(a.vx[ka] - b.vx[kb]), std::abs(a.vy[ka] - b.vy[kb])});
    }
  bounded("difference of velocity over the largest", difference / largest, 1e-9);
}

TEST(Robustness, ARunThatIsCutInTwoHasTheSameBits) {
  const auto make = [] { return shaken_box(2, oblique_wave(10.0), elastic_box(20.0, 10.0, 1.0)); };
  const Scene whole = make();
  Stepper first(*whole.domain, 0.0, whole.source);
  while (first.steps() < 150)
    first.step();
  const SavedState saved = saved_state(*whole.domain, first);
  const Scene again = make();
  Stepper second(*again.domain, 0.0, again.source);
  restore_state(saved, *again.domain, second);
  while (first.steps() < 300) {
    first.step();
    second.step();
  }
  expect_same_bits(whole.domain->sets, again.domain->sets);
  reaches("speed, so that there is something to compare", fastest(*whole.domain), 1e-3, "m/s");
}

} // namespace
} // namespace tremolo
