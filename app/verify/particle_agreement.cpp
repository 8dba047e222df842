#include "app/verify/particle_agreement.hpp"

#include "app/verify/exact_velocity.hpp"
#include "scene/plan/wave/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace tremolo::app {
namespace {

/// Particles whose levels differ by less than this part of the mesh size lie in one row.
constexpr double row_tolerance = 1e-3;

/// Gauss-Newton steps of the phase lag, and the step (s) below which it is found. It takes two or three.
constexpr int most_steps = 10;
constexpr double lag_tolerance = 1e-7;

/// A field below this part of the incident wave's peak is rounding.
constexpr double at_rest = 1e-6;

enum Region : std::size_t { whole, interior, near_sides, near_base, region_count };
constexpr std::array<const char*, region_count> region_names{"whole", "interior", "near sides", "near base"};

using Lags = std::array<double, region_count>;

struct Particle {
  double x, y;
  std::size_t level;
  std::array<bool, region_count> in;
};

struct Particles {
  std::vector<Particle> all;
  std::vector<double> levels; ///< m
};

/// Sums over the particles of a region and the frames.
struct Sums {
  std::size_t count = 0;
  double error2 = 0.0, exact2 = 0.0;
  double largest_error2 = 0.0, largest_exact2 = 0.0;
  double rate_error = 0.0, rate2 = 0.0;

  void add(const ExactVelocity::Value& e, double error_x, double error_y) {
    const double error = error_x * error_x + error_y * error_y;
    const double exact = e.vx * e.vx + e.vy * e.vy;
    ++count;
    error2 += error;
    exact2 += exact;
    largest_error2 = std::max(largest_error2, error);
    largest_exact2 = std::max(largest_exact2, exact);
    rate_error += e.ax * error_x + e.ay * error_y;
    rate2 += e.ax * e.ax + e.ay * e.ay;
  }

  double lag_step() const { return rate2 > 0.0 ? -rate_error / rate2 : 0.0; }
};

/// Groups the particles in rows of equal level, so that each row needs one history.
void assign_levels(Particles& particles, double tolerance) {
  std::vector<std::size_t> order(particles.all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return particles.all[i].y; });
  for (const std::size_t i : order) {
    Particle& particle = particles.all[i];
    if (particles.levels.empty() || particle.y - particles.levels.back() > tolerance)
      particles.levels.push_back(particle.y);
    particle.level = particles.levels.size() - 1;
  }
}

Particles place_particles(const results::RunReader& run, const scene::Case& scene, double width) {
  const scene::Box& box = scene.mesh.box;
  const std::vector<double> position = initial_positions(run);
  Particles particles;
  for (std::size_t i = 0; i < position.size(); i += 2) {
    const double x = position[i];
    const double y = position[i + 1];
    const bool by_side = x - box.x_min < width || box.x_max - x < width;
    const bool by_base = y - box.y_min < width;
    particles.all.push_back({x, y, 0, {true, !by_side && !by_base, by_side, by_base}});
  }
  assign_levels(particles, row_tolerance * scene.mesh.size);
  return particles;
}

/// The sums with each region's exact field delayed by its lag. Adds |v - e|^2 of each particle to
/// `particle_error2` if there is one.
std::array<Sums, region_count> compare(const results::RunReader& run, const Particles& particles,
                                       const ExactVelocity& exact, const Lags& lags,
                                       std::vector<double>* particle_error2) {
  std::array<Sums, region_count> sums;
  for (std::size_t frame = 0; frame < run.frame_times().size(); ++frame) {
    const double t = run.frame_times()[frame];
    const std::vector<double> v = velocities(run, frame, particles.all.size());
    for (std::size_t i = 0; i < particles.all.size(); ++i) {
      const Particle& particle = particles.all[i];
      for (std::size_t r = 0; r < region_count; ++r) {
        if (!particle.in[r])
          continue;
        const ExactVelocity::Value e = exact.at(particle.level, particle.x, t - lags[r]);
        const double error_x = v[2 * i] - e.vx;
        const double error_y = v[2 * i + 1] - e.vy;
        sums[r].add(e, error_x, error_y);
        if (particle_error2 != nullptr && r == whole)
          (*particle_error2)[i] += error_x * error_x + error_y * error_y;
      }
    }
  }
  return sums;
}

Lags best_lags(const results::RunReader& run, const Particles& particles, const ExactVelocity& exact,
               std::array<Sums, region_count> sums) {
  Lags lags{};
  for (int step = 0; step < most_steps; ++step) {
    double largest = 0.0;
    for (std::size_t r = 0; r < region_count; ++r) {
      lags[r] += sums[r].lag_step();
      largest = std::max(largest, std::abs(sums[r].lag_step()));
    }
    if (largest < lag_tolerance)
      break;
    sums = compare(run, particles, exact, lags, nullptr);
  }
  return lags;
}

double peak_velocity(const scene::Motion& motion) {
  double peak = 0.0;
  for (const double v : scene::sampled(motion).velocity)
    peak = std::max(peak, std::abs(v));
  return peak;
}

Agreement agreement(std::size_t region, const Sums& sums, double lag, std::size_t frames,
                    double incident_peak) {
  const double exact_peak = std::sqrt(sums.largest_exact2);
  if (exact_peak <= at_rest * incident_peak)
    throw std::runtime_error(
        fmt::format("the exact velocity in the region '{}' never exceeds {:.2g} m/s at the {} frames: the "
                    "wave has not arrived, there is nothing to compare",
                    region_names[region], exact_peak, frames));
  return {region_names[region], sums.count / frames, std::sqrt(sums.error2 / sums.exact2),
          std::sqrt(sums.largest_error2 / sums.largest_exact2), lag};
}

} // namespace

std::vector<double> initial_positions(const results::RunReader& run) {
  if (run.frame_times().empty())
    throw std::runtime_error("the run holds no particle frame");
  std::vector<double> position = run.frame_field(0, "position").values;
  const auto fields = run.frame_fields(0);
  if (std::ranges::find(fields, "displacement") != fields.end()) {
    const auto moved = run.frame_field(0, "displacement").values;
    std::ranges::transform(position, moved, position.begin(), std::minus<>());
  }
  return position;
}

std::vector<double> velocities(const results::RunReader& run, std::size_t frame, std::size_t particles) {
  const auto fields = run.frame_fields(frame);
  if (std::ranges::find(fields, "velocity") == fields.end())
    throw std::runtime_error("the run's frames hold no velocity: add \"velocity\" to [output] fields");
  std::vector<double> v = run.frame_field(frame, "velocity").values;
  if (v.size() != 2 * particles)
    throw std::runtime_error(
        fmt::format("frame {} holds {} particles, the first one {}", frame, v.size() / 2, particles));
  const auto wrong = std::ranges::find_if(v, [](double value) { return !std::isfinite(value); });
  if (wrong != v.end())
    throw std::runtime_error(
        fmt::format("the velocity of particle {} at t = {:g} s is {}: the run is unstable",
                    (wrong - v.begin()) / 2, run.frame_times()[frame], *wrong));
  return v;
}

ParticleAgreement compare_particles(const results::RunReader& run, const scene::Case& scene,
                                    const wavefield::Superposition& field) {
  const scene::Box& box = scene.mesh.box;
  const double width = 0.25 * std::min(box.width(), scene.surface_level - box.y_min);
  const Particles particles = place_particles(run, scene, width);
  const std::vector<double>& times = run.frame_times();
  const scene::Motion motion = scene::motion(scene.motion);
  const ExactVelocity exact(field, particles.levels, {box.x_min, box.x_max, times.front(), times.back()},
                            scene::highest_frequency(scene));

  std::vector<double> error2(particles.all.size());
  const auto sums = compare(run, particles, exact, Lags{}, &error2);
  const Lags lags = best_lags(run, particles, exact, sums);

  ParticleAgreement result{.boundary_width = width, .regions = {}, .x = {}, .y = {}, .relative_error = {}};
  const double incident_peak = peak_velocity(motion);
  for (std::size_t r = 0; r < region_count; ++r)
    if (sums[r].count > 0)
      result.regions.push_back(agreement(r, sums[r], lags[r], times.size(), incident_peak));
  const double mean_exact2 = sums[whole].exact2 / static_cast<double>(sums[whole].count);
  for (std::size_t i = 0; i < particles.all.size(); ++i) {
    result.x.push_back(particles.all[i].x);
    result.y.push_back(particles.all[i].y);
    result.relative_error.push_back(std::sqrt(error2[i] / static_cast<double>(times.size()) / mean_exact2));
  }
  return result;
}

} // namespace tremolo::app
