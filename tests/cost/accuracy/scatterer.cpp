// Graded against uniform meshes: an oblique SV pulse meets a soft circular inclusion below the surface. Fine
// cells stand around the inclusion alone; the other ground, where wavelengths are long, has cells up to eight
// times wider, which may take longer steps (sub-cycling). The error is that of the mean velocities of all
// blocks of 2 m, relative L2 over time, against a uniform mesh of half the finest cells. Prints CSV:
//
//     cost_scatterer > scatterer.csv

#include "tests/support/box_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace tremolo;
using mpm_domain::Domain;

constexpr double width = 48.0;      // m
constexpr double depth = 20.0;      // m
constexpr double block = 2.0;       // m: the widest cells
constexpr double finest = 0.25;     // m
constexpr double end_time = 1.4;    // s
constexpr double sampling = 0.0025; // s
constexpr eq6::Vector centre{16.0, -6.0};
constexpr double radius = 2.0;

/// Ground of a fifth of the wave speeds in a circle, drawn as a polygon of the same area.
mpm_domain::Region inclusion() {
  constexpr int corners = 64;
  const double step = 2.0 * std::numbers::pi / corners;
  const double r = radius * std::sqrt(step / std::sin(step));
  mpm_domain::Region region{1, {}};
  for (int i = 0; i < corners; ++i)
    region.polygon.push_back({centre.x + r * std::cos(i * step), centre.y + r * std::sin(i * step)});
  return region;
}

mpm_domain::Spec ground(double cell_size, int levels, bool subcycle) {
  mpm_domain::Spec spec = test_support::elastic_box(width, depth, cell_size);
  spec.threads = 1;
  spec.scheme.subcycle = subcycle;
  spec.soils.push_back({"inclusion", materials::LinearElastic{{1700.0, 1.6e6, 0.28}}});
  spec.regions.push_back(inclusion());
  if (levels > 0)
    spec.refine = {{{centre.x - 3.0, centre.y - 3.0, centre.x + 3.0, centre.y + 3.0}, levels}};
  return spec;
}

/// Mean velocities (m/s) of the blocks at equal times, and what they took.
struct Motion {
  std::vector<eq6::Vector> v;
  double cpu = 0.0; ///< s
  double updates = 0.0;
  std::size_t particles = 0;
};

void block_means(const Domain& domain, std::vector<eq6::Vector>& means) {
  constexpr auto columns = static_cast<std::size_t>(width / block);
  means.assign(columns * static_cast<std::size_t>(depth / block), {});
  std::vector<double> masses(means.size(), 0.0);
  for (const mpm_domain::Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      const std::size_t b = columns * static_cast<std::size_t>(-p.y_initial[k] / block) +
                            static_cast<std::size_t>(p.x_initial[k] / block);
      means[b].x += p.mass[k] * p.vx[k];
      means[b].y += p.mass[k] * p.vy[k];
      masses[b] += p.mass[k];
    }
  for (std::size_t b = 0; b < means.size(); ++b)
    means[b] = {means[b].x / masses[b], means[b].y / masses[b]};
}

Motion run(double cell_size, int levels, bool subcycle = false) {
  const test_support::PlaneWave wave{
      .angle = 15.0 * std::numbers::pi / 180.0, .frequency = 3.0, .arrival = 0.4, .y_reference = -depth};
  const std::clock_t begin = std::clock();
  Domain domain(ground(cell_size, levels, subcycle));
  mpm_domain::Stepper stepper(domain, 0.0, test_support::plane_wave_source(domain, wave, true));
  Motion motion;
  motion.particles = domain.particle_count();
  std::vector<eq6::Vector> before, after;
  block_means(domain, after);
  double t_before = 0.0;
  for (long sample = 1; static_cast<double>(sample) * sampling < end_time;) {
    const double t_after = stepper.velocity_time();
    const double t = static_cast<double>(sample) * sampling;
    if (stepper.steps() > 0 && t <= t_after) {
      const double share = (t - t_before) / (t_after - t_before);
      for (std::size_t b = 0; b < after.size(); ++b)
        motion.v.push_back({before[b].x + share * (after[b].x - before[b].x),
                            before[b].y + share * (after[b].y - before[b].y)});
      ++sample;
      continue;
    }
    t_before = t_after;
    before = after;
    stepper.step();
    block_means(domain, after);
  }
  motion.updates = stepper.particle_updates();
  motion.cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return motion;
}

double relative_error(const Motion& motion, const Motion& reference) {
  double error2 = 0.0;
  double norm2 = 0.0;
  for (std::size_t i = 0; i < reference.v.size(); ++i) {
    error2 += std::pow(motion.v[i].x - reference.v[i].x, 2) + std::pow(motion.v[i].y - reference.v[i].y, 2);
    norm2 += std::pow(reference.v[i].x, 2) + std::pow(reference.v[i].y, 2);
  }
  return std::sqrt(error2 / norm2);
}

} // namespace

int main() {
  const Motion reference = run(0.5 * finest, 0);
  fmt::print("mesh,coarsest,levels,particles,relative_error,cpu_s,updates\n");
  const auto print = [&](const std::string& mesh, double cell_size, int levels, bool subcycle = false) {
    const Motion motion = run(cell_size, levels, subcycle);
    fmt::print("{},{:g},{},{},{:.6g},{:.4g},{:.6g}\n", mesh, cell_size, levels, motion.particles,
               relative_error(motion, reference), motion.cpu, motion.updates);
    std::fflush(stdout);
  };
  fmt::print("reference,{:g},0,{},0,{:.4g},{:.6g}\n", 0.5 * finest, reference.particles, reference.cpu,
             reference.updates);
  for (const double cell_size : {8 * finest, 4 * finest, 2 * finest, finest})
    print("uniform", cell_size, 0);
  for (const int levels : {1, 2, 3})
    print("graded", finest * (1 << levels), levels);
  for (const int levels : {1, 2, 3})
    print("graded with sub-cycling", finest * (1 << levels), levels, true);
}
