#include "wavefield/half_space_field.hpp"

#include "wavefield/plane_waves.hpp"
#include "wavefield/require.hpp"
#include "wavefield/synthesis.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace tremolo::wavefield {
namespace {

/// Window lengths over the time that matters. Below critical the synthesis is exact at any; beyond, the error
/// of the tails falls with the 7th power.
constexpr double padding_sub_critical = 4.0;
constexpr double padding_post_critical = 12.0;

void require_times(const TimeGrid& grid) {
  require(std::isfinite(grid.start), "start of the time grid", grid.start, "finite");
  require_positive("step of the time grid", grid.dt, "s");
  require(grid.count > 0, "number of times", static_cast<double>(grid.count), "at least 1");
}

void require_below_surface(std::span<const Point> points, double surface_level) {
  for (const Point& point : points) {
    require(std::isfinite(point.x), "x of a point", point.x, "finite");
    require(point.y <= surface_level && std::isfinite(point.y), "y of a point", point.y,
            "finite and not above the free surface at y = " + shortest(surface_level) + " m");
  }
}

} // namespace

HalfSpaceField::HalfSpaceField(const HalfSpace& half_space, const Incidence& incidence, double surface_level,
                               Signal signal)
    : half_space_(half_space), incidence_(incidence), surface_level_(surface_level),
      signal_(std::move(signal)) {
  validate(half_space_);
  validate(incidence_);
  validate(signal_);
  require(std::isfinite(surface_level), "level of the free surface", surface_level, "finite");
}

std::vector<History> HalfSpaceField::sample(std::span<const Point> points, const TimeGrid& grid,
                                            Part part) const {
  require_times(grid);
  require_below_surface(points, surface_level_);
  if (points.empty()) {
    return {};
  }
  const PlaneWaves all = plane_waves(half_space_, incidence_);
  const std::vector<PlaneWave> waves(all.begin(), part == Part::total ? all.end() : all.begin() + 1);
  const double advance = all[0].q.real() * (incidence_.y_reference - surface_level_);
  const double p = slowness_x();

  // The interval that holds the requested times and, at every point, the passing signal.
  double begin = grid.start;
  double end = grid.start + static_cast<double>(grid.count) * grid.dt;
  std::map<double, std::vector<std::size_t>> points_at_level;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points_at_level[points[i].y].push_back(i);
    for (const PlaneWave& wave : waves) {
      const double delay = p * (points[i].x - incidence_.x_reference) +
                           wave.q.real() * (points[i].y - surface_level_) - advance;
      begin = std::min(begin, signal_.begin + delay);
      end = std::max(end, signal_.end + delay);
    }
  }
  // The signal itself, undelayed, is sampled in the same window.
  begin = std::min(begin, signal_.begin);
  end = std::max(end, signal_.end);

  const bool has_tails = part == Part::total && is_post_critical(half_space_, incidence_);
  const double padding = has_tails ? padding_post_critical : padding_sub_critical;
  Synthesis synthesis(signal_, make_window(grid, begin, end, padding, signal_.highest_frequency), waves,
                      has_tails);

  std::vector<History> histories(points.size());
  for (const auto& [y, at_level] : points_at_level) {
    const auto spectra = synthesis.at_depth(y - surface_level_, advance);
    for (const std::size_t i : at_level) {
      histories[i] = synthesis.history(spectra, p * (points[i].x - incidence_.x_reference), grid.count);
    }
  }
  return histories;
}

} // namespace tremolo::wavefield
