#pragma once

// A run file that holds the exact field of its case, so that whatever is done to it is known exactly.

#include "results/run_file.hpp"
#include "scene/case.hpp"
#include "tests/support/flat_case.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tremolo::testing {

/// The flat case under SV at 15 degrees.
inline const std::string exact_case =
    with("angle_deg = 0.0", "angle_deg = 15.0",
         with("time = 1.0", "time = 0.6",
              with("duration_s = 2.0", "duration_s = 1.4", plus("[verify]\ntolerance = 0.025\n"))));

/// exact_case with the first occurrence of `old` replaced.
inline std::string exact_case_with(const std::string& old, const std::string& replacement) {
  return with(old, replacement, exact_case);
}

/// The same with ground that falls towards a lower free field on the left.
inline std::string unequal_surfaces_case() {
  return with("left = { model = \"wave\" }", "left = { model = \"wave\", surface = -2.0 }",
              with("form = \"total\"", "form = \"incident\"",
                   exact_case_with("[20.0, 0.0], [0.0, 0.0]]", "[20.0, 0.0], [4.0, 0.0], [0.0, -2.0]]")));
}

/// What a synthetic run differs from the exact field by.
struct Departure {
  double delay = 0.0; ///< s, of all velocities
  /// Factor on the velocity of the particle that starts at x, y.
  std::function<double(double x, double y)> factor = [](double, double) { return 1.0; };
  bool monitor = true;
  bool finished = true;
};

inline constexpr double exact_run_end = 1.4;             ///< s
inline constexpr double frame_interval = 0.05;           ///< s
inline constexpr std::size_t exact_run_particles = 800;  ///< 2 x 2 a cell
inline constexpr double exact_run_energy_residual = 0.5; ///< of a largest kinetic energy of 100, J/m

/// The lattice of the case's particles.
inline std::vector<wavefield::Point> lattice() {
  std::vector<wavefield::Point> points;
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 40; ++i)
      points.push_back({0.25 + 0.5 * i, -9.75 + 0.5 * j});
  return points;
}

/// Writes frames of position, displacement and velocity every 0.05 s, a monitor "centre" at (10.25, -4.75) m
/// every 0.01 s, and an energy ledger.
inline void write_exact_run(const std::filesystem::path& file, const Departure& departure = {},
                            const std::string& case_text = exact_case) {
  const scene::Case scene = scene::parse(case_text, "case.toml", ".");
  const wavefield::Superposition field = wavefield::elastic_field(scene, scene.profile, scene.surface_level);
  const auto grid = [&](double dt) {
    return wavefield::TimeGrid{-departure.delay, dt,
                               static_cast<std::size_t>(std::lround(exact_run_end / dt)) + 1};
  };
  const auto points = lattice();
  const auto particles = field.sample(points, grid(frame_interval));
  const std::array<wavefield::Point, 1> centre{{{10.25, -4.75}}};
  const auto at_centre = field.sample(centre, grid(0.01)).front();

  results::RunWriter run(file, {.title = scene.title,
                                .case_text = case_text,
                                .plan = "{}",
                                .build_version = "test",
                                .compiler = "test",
                                .build_flags = "test"});
  auto& energy = run.add_series("/energy", std::array<std::string, 3>{"time", "kinetic", "residual"},
                                std::array<std::string, 3>{"s", "J/m", "J/m"});
  energy.append(std::array{0.0, 100.0, 0.1});
  energy.append(std::array{1.0, 20.0, -exact_run_energy_residual});
  if (departure.monitor) {
    auto& monitor = run.add_series(
        "/monitors/centre", std::array<std::string, 9>{"time", "x", "y", "ux", "uy", "vx", "vy", "ax", "ay"},
        std::array<std::string, 9>{"s", "m", "m", "m", "m", "m/s", "m/s", "m/s2", "m/s2"});
    for (std::size_t i = 0; i < at_centre.vx.size(); ++i)
      monitor.append(std::array{0.01 * static_cast<double>(i), centre[0].x + at_centre.ux[i],
                                centre[0].y + at_centre.uy[i], at_centre.ux[i], at_centre.uy[i],
                                at_centre.vx[i], at_centre.vy[i], at_centre.vx_rate[i],
                                at_centre.vy_rate[i]});
  }
  for (std::size_t frame = 0; frame < particles.front().vx.size(); ++frame) {
    std::vector<double> position, displacement, velocity;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const wavefield::History& h = particles[i];
      const double factor = departure.factor(points[i].x, points[i].y);
      position.insert(position.end(), {points[i].x + h.ux[frame], points[i].y + h.uy[frame]});
      displacement.insert(displacement.end(), {h.ux[frame], h.uy[frame]});
      velocity.insert(velocity.end(), {factor * h.vx[frame], factor * h.vy[frame]});
    }
    const std::array<results::Field, 3> fields{
        {{"position", "m", 2, std::span<const double>(position)},
         {"displacement", "m", 2, std::span<const double>(displacement)},
         {"velocity", "m/s", 2, std::span<const double>(velocity)}}};
    run.write_frame(frame_interval * static_cast<double>(frame), fields);
  }
  if (departure.finished)
    run.finish();
}

} // namespace tremolo::testing
