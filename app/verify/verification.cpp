#include "app/verify/verification.hpp"

#include "app/verify/exact_field.hpp"
#include "app/verify/exact_velocity.hpp"
#include "scene/plan/wave/motion.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tremolo::app {
namespace {

double largest(const std::vector<double>& values) {
  double size = 0.0;
  for (const double value : values)
    size = std::max(size, std::abs(value));
  return size;
}

std::vector<PointHistory> monitor_histories(const results::RunReader& run) {
  std::vector<PointHistory> points;
  for (const std::string& name : run.monitors()) {
    const results::SeriesData series = run.series("/monitors/" + name);
    if (series.rows() == 0)
      continue;
    points.push_back({.name = name,
                      .x = series.column("x").front() - series.column("ux").front(),
                      .y = series.column("y").front() - series.column("uy").front(),
                      .time = series.column("time"),
                      .exact_vx = {},
                      .exact_vy = {},
                      .vx = series.column("vx"),
                      .vy = series.column("vy")});
  }
  return points;
}

std::size_t nearest_particle(const ParticleAgreement& particles, double x, double y) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < particles.x.size(); ++i) {
    const double distance = std::hypot(particles.x[i] - x, particles.y[i] - y);
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

/// Histories of particles in the middle of the box, at the times of the frames.
std::vector<PointHistory> particle_histories(const results::RunReader& run, const scene::Case& scene,
                                             const ParticleAgreement& particles) {
  const scene::Box& box = scene.mesh.box;
  const double x = 0.5 * (box.x_min + box.x_max);
  const double top = scene.surface_level;
  const std::array<std::pair<const char*, double>, 3> levels{
      {{"surface", top}, {"middle", 0.5 * (top + box.y_min)}, {"base", box.y_min}}};
  std::vector<PointHistory> points;
  std::vector<std::size_t> chosen;
  for (const auto& [name, y] : levels) {
    const std::size_t i = nearest_particle(particles, x, y);
    chosen.push_back(i);
    points.push_back({.name = name,
                      .x = particles.x[i],
                      .y = particles.y[i],
                      .time = run.frame_times(),
                      .exact_vx = {},
                      .exact_vy = {},
                      .vx = {},
                      .vy = {}});
  }
  for (std::size_t frame = 0; frame < run.frame_times().size(); ++frame) {
    const std::vector<double> v = velocities(run, frame, particles.x.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
      points[p].vx.push_back(v[2 * chosen[p]]);
      points[p].vy.push_back(v[2 * chosen[p] + 1]);
    }
  }
  return points;
}

void add_exact(PointHistory& point, const scene::Case& scene, const wavefield::Superposition& field) {
  const std::array<double, 1> level{point.y};
  const ExactVelocity exact(field, level, {point.x, point.x, point.time.front(), point.time.back()},
                            scene::highest_frequency(scene));
  for (const double t : point.time) {
    const ExactVelocity::Value e = exact.at(0, point.x, t);
    point.exact_vx.push_back(e.vx);
    point.exact_vy.push_back(e.vy);
  }
}

std::optional<double> energy_residual(const results::RunReader& run) {
  if (!run.has_table("/energy"))
    return std::nullopt;
  const results::SeriesData ledger = run.series("/energy");
  const double kinetic = largest(ledger.column("kinetic"));
  if (kinetic == 0.0)
    return std::nullopt;
  return largest(ledger.column("residual")) / kinetic;
}

} // namespace

Verification verify(const results::RunReader& run, const scene::Case& scene) {
  if (run.status() != "complete")
    throw std::runtime_error(
        fmt::format("only a complete run can be verified, this one is {}", run.status()));
  if (const auto why = why_not_exact(scene))
    throw std::runtime_error(fmt::format("the exact field of this case is not known: {}", *why));
  const auto field = wavefield::elastic_field(scene, scene.profile, scene.surface_level);

  Verification result;
  result.particles = compare_particles(run, scene, field);
  result.points = monitor_histories(run);
  if (result.points.empty())
    result.points = particle_histories(run, scene, result.particles);
  for (PointHistory& point : result.points)
    add_exact(point, scene, field);
  result.energy_residual = energy_residual(run);
  return result;
}

} // namespace tremolo::app
