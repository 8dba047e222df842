#include "wavefield/layers/layered_field.hpp"

#include "base/require.hpp"
#include "wavefield/signal/synthesis.hpp"
#include "wavefield/signal/window_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tremolo::wavefield {
namespace {

void require_times(const TimeGrid& grid) {
  require(std::isfinite(grid.start), "start of the time grid", grid.start, "finite");
  require_positive("step of the time grid", grid.dt, "s");
  require(grid.count > 0, "number of times", static_cast<double>(grid.count), "at least 1");
}

void require_places(std::span<const Point> points, const FieldSetup& setup) {
  const double top_of_half_space = setup.top_of(setup.profile.layers.size());
  for (const Point& point : points) {
    require(std::isfinite(point.x), "x of a point", point.x, "finite");
    require(point.y <= setup.surface_level && std::isfinite(point.y), "y of a point", point.y,
            "finite and not above the free surface at y = " + shortest(setup.surface_level) + " m");
    require(setup.part == Part::total || setup.medium_at(point) == setup.profile.layers.size(),
            "y of a point for the incident wave alone", point.y,
            "in the half-space, whose top is at y = " + shortest(top_of_half_space) +
                " m: above it no wave is the incident one");
  }
}

} // namespace

LayeredField::LayeredField(LayeredHalfSpace profile, const Incidence& incidence, double surface_level,
                           Signal signal, const SynthesisOptions& options)
    : profile_(std::move(profile)), incidence_(incidence), surface_level_(surface_level),
      signal_(std::move(signal)), options_(options) {
  validate(profile_);
  validate(incidence_);
  validate(signal_);
  require(std::isfinite(surface_level), "level of the free surface", surface_level, "finite");
  require(profile_.half_space_damping == 0.0 || incidence.y_reference <= top_of_half_space(),
          "y of the reference point", incidence.y_reference,
          "in the damped half-space, whose top is at y = " + shortest(top_of_half_space()) + " m");
  if (options.padding) {
    require(*options.padding >= 1.0 && std::isfinite(*options.padding), "padding of the window",
            *options.padding, "at least 1 and finite");
  }
  if (options.exponential_window) {
    const std::string reason = why_no_exponential_window(setup(Part::total));
    if (!reason.empty())
      throw std::invalid_argument("no exponential window: " + reason);
  }
}

LayeredField LayeredField::with_signal(Signal signal, double velocity_scale) const {
  SynthesisOptions options = options_;
  options.velocity_scale = velocity_scale;
  return {profile_, incidence_, surface_level_, std::move(signal), options};
}

bool LayeredField::has_tails(Part part) const {
  return wavefield::has_tails(setup(part));
}

FieldSetup LayeredField::setup(Part part) const {
  return {profile_, incidence_, surface_level_, signal_, part};
}

std::vector<History> LayeredField::sample(std::span<const Point> points, const TimeGrid& grid, Part part,
                                          const Quantities& quantities) const {
  const FieldSetup field = setup(part);
  require_times(grid);
  require_places(points, field);
  if (points.empty())
    return {};
  const Window window = choose_window(field, points, grid, options_);
  return Synthesis(field, window).sample(points, grid.count, quantities);
}

WrapAroundError LayeredField::wrap_around_error(std::span<const Point> points, const TimeGrid& grid) const {
  const FieldSetup field = setup(Part::total);
  require_times(grid);
  require_places(points, field);
  if (points.empty())
    throw std::invalid_argument("the error of the window needs at least one point");
  const Window chosen = choose_window(field, points, grid, options_);
  const Interval interval = interval_of(field, points, grid);
  SynthesisOptions twice = options_;
  twice.padding = 2.0 * chosen.duration() / (interval.end - interval.begin);
  const Window doubled = choose_window(field, points, grid, twice);

  const Quantities quantities{.strain = false, .rates = false};
  const auto with_chosen = Synthesis(field, chosen).sample(points, grid.count, quantities);
  const auto with_doubled = Synthesis(field, doubled).sample(points, grid.count, quantities);
  constexpr std::array displacement{&History::ux, &History::uy};
  constexpr std::array velocity{&History::vx, &History::vy};
  constexpr std::array stress{&History::sxx, &History::syy, &History::sxy};
  return {.window = chosen.duration(),
          .displacement = relative_change(with_chosen, with_doubled, displacement),
          .velocity = relative_change(with_chosen, with_doubled, velocity),
          .stress = relative_change(with_chosen, with_doubled, stress)};
}

} // namespace tremolo::wavefield
