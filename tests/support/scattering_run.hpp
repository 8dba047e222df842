#pragma once

// Elastic ground that scatters a plane SV wave, in a box that is cut out of it in different ways: a slope of
// 10 m at 45 degrees, its left free surface at y = 0 and its right one at y = 10 m; a canyon, 16 m wide and
// 8 m deep; a block on the surface, 6 m wide, 8 m high, of 20 t/m3 and of the ground's wave speeds.

#include "mpm_domain/step/stepper.hpp"
#include "tests/support/box_models.hpp"
#include "tests/support/box_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::test_support {

enum class Scatterer { slope, canyon, block, none };

/// What enters through the base under two surfaces. Under level ground all but `incident` are the total
/// field.
enum class BaseField {
  incident, ///< the incident wave alone
  left,     ///< total field under the left surface, all along
  step,     ///< that of the left surface up to the middle of the slope, then that of the right one
  blend,    ///< the two blended linearly from toe to crest
  across,   ///< the two blended linearly over the whole base
  ends,  ///< the incident wave under the middle half, blended into the total field of the side to either end
  local, ///< total field under a level surface as high as the ground above the face
};
enum class Absorber {
  dashpots,
  springs,     ///< beside the dashpots of all sides
  layer_below, ///< layer at the base, dashpots at the sides
  layers,
  layers_and_springs, ///< layers at the sides, springs beside the dashpots of the base
};

struct ScatteringRun {
  double width = 0.0; ///< of the box, the scatterer in its middle, m
  BaseField field = BaseField::incident;
  Absorber absorber = Absorber::dashpots;
  double angle_deg = 0.0;
  int layer_cells = 10;
  Scatterer scatterer = Scatterer::slope;
  double cell = 2.0;         ///< m
  double base_level = -20.0; ///< m
  double across = 1.0;       ///< a_n of springs; a_t is half of it

  bool surfaces_differ() const { return scatterer == Scatterer::slope; }
  double right_surface() const;
};

inline constexpr double crest_height = 10.0; ///< m
inline constexpr double end_time = 3.5;      ///< s

inline double ScatteringRun::right_surface() const {
  return surfaces_differ() ? crest_height : 0.0;
}

inline double surface_above(double x) {
  return std::clamp(x + 0.5 * crest_height, 0.0, crest_height);
}

/// The same incident wave under a level surface at y = `surface`.
inline eq6::FreeField under_surface(PlaneWave wave, double surface, double x, double y, double t,
                                    int rays = 3) {
  wave.y_reference -= surface;
  return wave.at(x, y - surface, t, rays);
}

inline eq6::FreeField mixed(const eq6::FreeField& a, const eq6::FreeField& b, double share) {
  const auto of = [share](double p, double q) { return (1.0 - share) * p + share * q; };
  return {{of(a.velocity.x, b.velocity.x), of(a.velocity.y, b.velocity.y)},
          {of(a.stress.xx, b.stress.xx), of(a.stress.yy, b.stress.yy), of(a.stress.xy, b.stress.xy)}};
}

inline eq6::FreeField free_field(const ScatteringRun& run, const PlaneWave& wave,
                                 const mpm_domain::BoundaryFace& face, double t) {
  const auto [x, y] = face.position;
  const auto under = [&](double surface) { return under_surface(wave, surface, x, y, t); };
  if (face.side == mpm_domain::Side::left)
    return under(0.0);
  if (face.side == mpm_domain::Side::right)
    return under(run.right_surface());
  if (!run.surfaces_differ() && run.field != BaseField::incident)
    return under(0.0);
  switch (run.field) {
  case BaseField::incident:
    break;
  case BaseField::left:
    return under(0.0);
  case BaseField::step:
    return under(x < 0.0 ? 0.0 : crest_height);
  case BaseField::blend:
    return mixed(under(0.0), under(crest_height), surface_above(x) / crest_height);
  case BaseField::across:
    return mixed(under(0.0), under(crest_height), x / run.width + 0.5);
  case BaseField::ends: {
    const double share = std::clamp(4.0 * std::abs(x) / run.width - 1.0, 0.0, 1.0);
    return mixed(under_surface(wave, 0.0, x, y, t, 1), under(x < 0.0 ? 0.0 : crest_height), share);
  }
  case BaseField::local:
    return under(surface_above(x));
  }
  return under_surface(wave, 0.0, x, y, t, 1);
}

inline std::vector<Vector> ground_outline(const ScatteringRun& run) {
  const double half = 0.5 * run.width;
  const double base_level = run.base_level;
  switch (run.scatterer) {
  case Scatterer::slope:
    return {{-half, base_level}, {half, base_level}, {half, crest_height},
            {5.0, crest_height}, {-5.0, 0.0},        {-half, 0.0}};
  case Scatterer::canyon:
    return {{-half, base_level}, {half, base_level}, {half, 0.0}, {8.0, 0.0},
            {8.0, -8.0},         {-8.0, -8.0},       {-8.0, 0.0}, {-half, 0.0}};
  case Scatterer::block:
  case Scatterer::none:
    break;
  }
  return {{-half, base_level}, {half, base_level}, {half, 0.0}, {-half, 0.0}};
}

inline mpm_domain::Spec scattering_spec(const ScatteringRun& run) {
  const double half = 0.5 * run.width;
  mpm_domain::Spec spec = elastic_box(run.width, 1.0, run.cell);
  spec.box = {-half, run.base_level, half, crest_height};
  spec.regions = {{0, ground_outline(run)}};
  if (run.scatterer == Scatterer::block) {
    materials::Elasticity heavy = materials::elasticity(spec.soils.front().law);
    const double times = 20e3 / heavy.density;
    heavy.density *= times;
    heavy.young *= times;
    spec.soils.push_back({"block", materials::LinearElastic{heavy}});
    spec.regions.push_back({1, {{-3.0, 0.0}, {3.0, 0.0}, {3.0, 8.0}, {-3.0, 8.0}}});
  }
  spec.threads = 1;
  spec.layer_cells = run.layer_cells;
  using enum mpm_domain::Side;
  if (run.absorber == Absorber::layer_below)
    spec.matched_sides = {base};
  if (run.absorber == Absorber::layers)
    spec.matched_sides = {left, right, base};
  if (run.absorber == Absorber::layers_and_springs)
    spec.matched_sides = {left, right};
  const Vector centre{0.0, 0.5 * run.right_surface()};
  if (run.absorber == Absorber::springs)
    add_springs(spec, run.across, 0.5 * run.across, centre, run.surfaces_differ());
  if (run.absorber == Absorber::layers_and_springs)
    spec.springs = {{base, run.across, 0.5 * run.across, centre, run.surfaces_differ()}};
  return spec;
}

/// Velocity of the particles around the scatterer, sampled in time: what a user would look at.
struct ScatteredMotion {
  std::vector<double> velocity; ///< [sample][particle][2]
  double largest = 0.0;         ///< of any velocity component, m/s
};

inline constexpr double sample = 0.015; ///< s
/// A whole number of steps, each below its limit: 0.65 h/c_p is 3.75 ms in cells of 1 m.
inline long steps_a_sample(double cell) {
  return cell < 2.0 ? 5 : 4;
}

inline ScatteredMotion shake(const ScatteringRun& run) {
  mpm_domain::Spec spec = scattering_spec(run);
  const long steps = steps_a_sample(run.cell);
  spec.scheme.dt = sample / static_cast<double>(steps);
  mpm_domain::Domain domain(spec);
  PlaneWave wave;
  wave.angle = run.angle_deg * std::numbers::pi / 180.0;
  wave.frequency = 2.0;
  wave.y_reference = run.base_level;
  // The wave reaches the left end of a wide box long before the scatterer; one second before its pulse all is
  // quiet.
  const double lead = std::max(0.0, 0.5 * run.width * wave.p());
  mpm_domain::Stepper stepper(domain, -sample * std::ceil(lead / sample),
                              [&](long, double t, auto, std::span<eq6::FreeField> field) {
                                for (std::size_t f = 0; f < field.size(); ++f)
                                  field[f] = free_field(run, wave, domain.boundary.faces()[f], t);
                              });

  const mpm_domain::Particles& set = domain.sets.front();
  std::vector<std::pair<std::pair<double, double>, std::uint32_t>> watched; // by place, for all cuts alike
  for (std::size_t k = 0; k < set.size(); ++k)
    if (std::abs(set.x[k]) < 15.0 && set.y[k] > -10.0)
      watched.push_back({{std::round(8.0 * set.x[k]), std::round(8.0 * set.y[k])}, set.id[k]});
  std::ranges::sort(watched);
  ScatteredMotion motion;
  while (stepper.time() < end_time) {
    stepper.step();
    if (stepper.time() < 0.5 * spec.scheme.dt.value() || stepper.steps() % steps != 0)
      continue;
    for (const auto& [position, id] : watched) {
      const std::size_t k = set.index_of[id];
      motion.velocity.insert(motion.velocity.end(), {set.vx[k], set.vy[k]});
      motion.largest = std::max({motion.largest, std::abs(set.vx[k]), std::abs(set.vy[k])});
    }
  }
  return motion;
}

/// Relative L2 difference over what both have sampled.
inline double difference(const ScatteredMotion& run, const ScatteredMotion& reference) {
  double error = 0.0;
  double norm = 0.0;
  for (std::size_t i = 0; i < std::min(run.velocity.size(), reference.velocity.size()); ++i) {
    error += std::pow(run.velocity[i] - reference.velocity[i], 2);
    norm += std::pow(reference.velocity[i], 2);
  }
  return std::sqrt(error / norm);
}

} // namespace tremolo::test_support
