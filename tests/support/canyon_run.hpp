#pragma once

// A canyon in a homogeneous half-space under a plane SV wave, without processes: the traction source
// evaluates the closed form of the flat half-space on every face of the box, whatever the canyon sends out is
// the scattered field. The canyon's surface is y = -depth exp(-x^2/(2 sigma^2)).

#include "mpm_domain/step/stepper.hpp"
#include "tests/support/plane_wave.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace tremolo::test_support {

/// Ground of 200 m/s below a Gaussian canyon.
struct Canyon {
  double cell_size = 1.0; ///< m
  double width = 160.0;   ///< of the box, m; the canyon is in its middle, at x = 0
  double depth = 64.0;    ///< of the box below the flat ground, m
  double angle_deg = 0.0;
  bool layers = true; ///< matched layers on all sides instead of dashpots
  int layer_cells = 10;
  mpm_domain::Transfer transfer = mpm_domain::Transfer::apic;
  double canyon_depth = 16.0; ///< m
  double sigma = 10.0;        ///< m
  bool notch = false; ///< a notch as deep and 2.4 sigma wide instead: its walls lie on lines of a grid of 4 m
  double end = 1.6;   ///< s after the incident wave has met the flat ground at x = 0
};

inline constexpr double sampling = 0.02;    ///< s
inline constexpr double before_pulse = 0.5; ///< s: a Ricker pulse of 2.5 Hz has not begun then

inline constexpr materials::Elasticity canyon_ground{1800.0, 187.2e6, 0.3}; ///< c_s = 200 m/s

inline mpm_domain::Spec canyon_spec(const Canyon& canyon) {
  using mpm_domain::Side;
  mpm_domain::Spec spec;
  spec.box = {-0.5 * canyon.width, -canyon.depth, 0.5 * canyon.width, 0.0};
  spec.cell_size = canyon.cell_size;
  spec.soils = {{"ground", materials::LinearElastic{canyon_ground}}};
  mpm_domain::Region ground{0, {{spec.box.x_min, -canyon.depth}, {spec.box.x_max, -canyon.depth}}};
  ground.polygon.push_back({spec.box.x_max, 0.0});
  if (canyon.notch)
    for (const auto& [x, y] : {std::pair(1.2, 0.0), {1.2, -1.0}, {-1.2, -1.0}, {-1.2, 0.0}})
      ground.polygon.push_back({x * canyon.sigma, y * canyon.canyon_depth});
  for (double x = 5.0 * canyon.sigma; !canyon.notch && x >= -5.0 * canyon.sigma; x -= 0.25)
    ground.polygon.push_back({x, -canyon.canyon_depth * std::exp(-0.5 * std::pow(x / canyon.sigma, 2))});
  ground.polygon.push_back({spec.box.x_min, 0.0});
  spec.regions = {ground};
  spec.threads = 1;
  spec.scheme.transfer = canyon.transfer;
  spec.scheme.dt = sampling / std::ceil(sampling / (0.32 * canyon.cell_size / canyon_ground.p_wave_speed()));
  spec.layer_cells = canyon.layer_cells;
  if (canyon.layers)
    spec.matched_sides = {Side::left, Side::right, Side::base};
  return spec;
}

/// SV Ricker pulse of 2.5 Hz whose incident wave meets the flat ground at x = 0 at t = 0.
inline PlaneWave canyon_wave(double angle_deg) {
  PlaneWave wave;
  wave.density = canyon_ground.density;
  wave.vs = canyon_ground.s_wave_speed();
  wave.vp = canyon_ground.p_wave_speed();
  wave.angle = angle_deg * std::numbers::pi / 180.0;
  wave.frequency = 2.5;
  wave.arrival = 0.0;
  wave.y_reference = 0.0;
  return wave;
}

/// Velocities of the particles of one run that lie in a box, at equal times: one row a sample, in the order
/// of the particles' places.
using Seen = std::vector<std::vector<eq6::Vector>>;

/// @param watched particles that start in it are watched
inline Seen run_canyon(const Canyon& canyon, const mpm_domain::Box& watched) {
  mpm_domain::Domain domain(canyon_spec(canyon));
  const PlaneWave wave = canyon_wave(canyon.angle_deg);
  const double way = 0.5 * canyon.width * std::sin(wave.angle) + canyon.depth * std::cos(wave.angle);
  const double start = -sampling * std::ceil((way / wave.vs + before_pulse) / sampling);
  mpm_domain::Stepper stepper(domain, start, [&](long, double t, auto, std::span<eq6::FreeField> field) {
    for (std::size_t f = 0; f < field.size(); ++f) {
      const auto [x, y] = domain.boundary.faces()[f].position;
      field[f] = wave.at(x, y, t);
    }
  });
  const mpm_domain::Particles& set = domain.sets.front();
  std::map<std::pair<long, long>, std::uint32_t> by_place;
  for (std::size_t k = 0; k < set.size(); ++k)
    if (set.x[k] > watched.x_min && set.x[k] < watched.x_max && set.y[k] > watched.y_min)
      by_place[{std::lround(8.0 * set.x[k] / canyon.cell_size),
                std::lround(8.0 * set.y[k] / canyon.cell_size)}] = set.id[k];
  const long between = std::lround(0.02 / stepper.dt());
  Seen seen;
  while (stepper.time() < canyon.end) {
    stepper.step();
    if (stepper.steps() % between != 0 || stepper.time() < -before_pulse - 0.5 * sampling)
      continue;
    std::vector<eq6::Vector>& sample = seen.emplace_back();
    for (const auto& [place, id] : by_place)
      sample.push_back({set.vx[set.index_of[id]], set.vy[set.index_of[id]]});
  }
  return seen;
}

/// Relative L2 difference over all particles and samples.
inline double relative_difference(const Seen& a, const Seen& b) {
  double difference = 0.0;
  double norm = 0.0;
  for (std::size_t s = 0; s < b.size(); ++s)
    for (std::size_t i = 0; i < b[s].size(); ++i) {
      difference += std::pow(a.at(s).at(i).x - b[s][i].x, 2) + std::pow(a[s].at(i).y - b[s][i].y, 2);
      norm += b[s][i].x * b[s][i].x + b[s][i].y * b[s][i].y;
    }
  return std::sqrt(difference / norm);
}

} // namespace tremolo::test_support
