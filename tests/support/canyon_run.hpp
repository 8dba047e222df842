#pragma once

// A canyon in a homogeneous half-space under a plane SV wave, without processes: the traction source
// evaluates the closed form of the flat half-space on every face of the box, whatever the canyon sends out is
// the scattered field. The canyon's surface is y = -depth exp(-x^2/(2 sigma^2)).

#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "tests/support/box_models.hpp"
#include "tests/support/plane_wave.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
  bool springs = false; ///< a = 1 and 0.5 beside the dashpots
  mpm_domain::Transfer transfer = mpm_domain::Transfer::apic;
  mpm_domain::Dispersion dispersion = mpm_domain::Dispersion::plain;
  double canyon_depth = 16.0; ///< m
  double sigma = 10.0;        ///< m
  bool notch = false; ///< a notch as deep and 2.4 sigma wide instead: its walls lie on lines of a grid of 4 m
  double end = 1.6;   ///< s after the incident wave has met the flat ground at x = 0
};

inline constexpr double sampling = 0.02;    ///< s
inline constexpr double before_pulse = 0.5; ///< s: a Ricker pulse of 2.5 Hz has not begun then

inline constexpr materials::Elasticity canyon_ground{1800.0, 187.2e6, 0.3}; ///< c_s = 200 m/s

/// Elevation of the ground of a Gaussian canyon, m.
inline double canyon_surface(const Canyon& canyon, double x) {
  return -canyon.canyon_depth * std::exp(-0.5 * std::pow(x / canyon.sigma, 2));
}

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
    ground.polygon.push_back({x, canyon_surface(canyon, x)});
  ground.polygon.push_back({spec.box.x_min, 0.0});
  spec.regions = {ground};
  spec.threads = 1;
  spec.scheme.transfer = canyon.transfer;
  spec.scheme.dispersion = canyon.dispersion;
  spec.scheme.dt = sampling / std::ceil(sampling / (0.32 * canyon.cell_size / canyon_ground.p_wave_speed()));
  spec.layer_cells = canyon.layer_cells;
  if (canyon.layers)
    spec.matched_sides = {Side::left, Side::right, Side::base};
  if (canyon.springs)
    add_springs(spec, 1.0, 0.5, {0.0, 0.0});
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

/// Mean velocities of the particles of one run in squares of a box, at equal times: one row a sample, in the
/// order of the squares' places.
using Seen = std::vector<std::vector<eq6::Vector>>;

/// @param watched  squares that lie in it are watched
/// @param side     of the squares, m, which are full of soil; 0: half a cell, the room of one particle
inline Seen run_canyon(const Canyon& canyon, const mpm_domain::Box& watched, double side = 0.0) {
  mpm_domain::Domain domain(canyon_spec(canyon));
  const PlaneWave wave = canyon_wave(canyon.angle_deg);
  const double way = 0.5 * canyon.width * std::sin(wave.angle) + canyon.depth * std::cos(wave.angle);
  // Half a step late, so that velocities, which belong to the middle of steps, are those of the samples'
  // times.
  const double start = -sampling * std::ceil((way / wave.vs + before_pulse) / sampling);
  const double half_step = 0.5 * *domain.spec.scheme.dt;
  mpm_domain::Stepper stepper(domain, start + half_step,
                              [&](long, double t, auto, std::span<eq6::FreeField> field) {
                                for (std::size_t f = 0; f < field.size(); ++f) {
                                  const auto [x, y] = domain.boundary.faces()[f].position;
                                  field[f] = wave.at(x, y, t);
                                }
                              });
  const mpm_domain::Particles& set = domain.sets.front();
  const double square = side > 0.0 ? side : 0.5 * canyon.cell_size;
  std::map<std::pair<long, long>, std::vector<std::uint32_t>> by_place;
  for (std::size_t k = 0; k < set.size(); ++k) {
    const double i = std::floor(set.x[k] / square);
    const double j = std::floor(set.y[k] / square);
    const double lowest = canyon_surface(canyon, square * std::min(std::abs(i), std::abs(i + 1.0)));
    const bool is_full = side == 0.0 || square * (j + 1.0) <= lowest;
    if (is_full && set.x[k] > watched.x_min && set.x[k] < watched.x_max && set.y[k] > watched.y_min)
      by_place[{std::lround(i), std::lround(j)}].push_back(set.id[k]);
  }
  const long between = std::lround(sampling / stepper.dt());
  Seen seen;
  while (stepper.velocity_time() < canyon.end - half_step) {
    stepper.step();
    if (stepper.steps() % between != 0 || stepper.velocity_time() < -before_pulse - half_step)
      continue;
    std::vector<eq6::Vector>& sample = seen.emplace_back();
    for (const auto& [position, ids] : by_place) {
      eq6::Vector& mean = sample.emplace_back();
      for (const std::uint32_t id : ids) {
        const Vector v = particle_velocity(domain, set, set.index_of[id]);
        mean.x += v.x / double(ids.size());
        mean.y += v.y / double(ids.size());
      }
    }
  }
  return seen;
}

/// Relative L2 difference over all squares and samples.
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
