#include "mpm_domain/process/output/sliding_mass_output.hpp"

#include "mpm_domain/process/output/add_history.hpp"
#include "mpm_domain/process/output/followed_point.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// The mass of a particle with the water in its pores, kg/m: the water moves with the grains nearly enough.
double whole_mass(const Particles& set, std::size_t k) {
  if (!set.traits.flowing)
    return set.mass[k];
  return set.mass[k] +
         set.water->fluid.density * set.water->porosity(set.mass[k], set.volume[k]) * set.volume[k];
}

scene::Box bounds(const scene::Polygon& polygon) {
  const auto [left, right] = std::ranges::minmax(polygon, {}, &scene::Point::x);
  const auto [low, high] = std::ranges::minmax(polygon, {}, &scene::Point::y);
  return {left.x, low.y, right.x, high.y};
}

/// The outline of a mass, with the box around it, which most particles are outside of.
struct Outline {
  explicit Outline(const scene::SlidingMass& mass) : corners(mass.outline.corners), box(bounds(corners)) {}

  bool holds_start_of(const Particles& set, std::size_t k) const {
    const scene::Point start{set.x_initial[k], set.y_initial[k]};
    return box.contains(start) && scene::contains(corners, start);
  }

  const scene::Polygon& corners;
  scene::Box box;
};

/// The positions of the particles of a set that began within an outline, in the order of ids: sums over them
/// do not depend on how particles are sorted.
std::vector<std::uint32_t> members(const Outline& outline, const Particles& set) {
  std::vector<std::uint32_t> members;
  set.index_of.for_all([&](std::uint32_t k) {
    if (outline.holds_start_of(set, k))
      members.push_back(k);
  });
  return members;
}

} // namespace

Wanted in_sliding_masses(const scene::Case& scene, const Ground& ground) {
  if (scene.sliding_masses.empty())
    return {};
  std::vector<Outline> outlines(scene.sliding_masses.begin(), scene.sliding_masses.end());
  return [&ground, outlines = std::move(outlines)](std::size_t s, std::size_t k) {
    const Particles& set = ground.sets[s];
    return !set.body && std::ranges::any_of(
                            outlines, [&](const Outline& outline) { return outline.holds_start_of(set, k); });
  };
}

SlidingMassOutput::SlidingMassOutput(const scene::Case& scene, results::RunWriter& writer) : scene_(scene) {
  for (const scene::SlidingMass& mass : scene.sliding_masses) {
    std::vector<double> outline;
    for (const scene::Point& corner : mass.outline.corners)
      outline.insert(outline.end(), {corner.x, corner.y});
    const std::string path = "/sliding_masses/" + mass.name;
    series_.emplace_back(path, &add_history(writer, path, sliding_mass_columns,
                                            std::array{results::Attribute{"outline", outline}}));
  }
}

void SlidingMassOutput::write_history(const Snapshot& snapshot, const Stepper& stepper) {
  const std::span<const Particles> sets = snapshot.sets_of_soil();
  for (std::size_t m = 0; m < series_.size(); ++m) {
    double mass = 0.0;
    std::array<double, 8> sums{};
    const Outline outline(scene_.sliding_masses[m]);
    for (std::size_t s = 0; s < sets.size(); ++s)
      for (const std::uint32_t k : members(outline, sets[s])) {
        const Particles& set = sets[s];
        const auto [x, u, v, a] = motion_in_space(snapshot, {s, set.id[k]}, stepper);
        const std::array values{x.x, x.y, u.x, u.y, v.x, v.y, a.x, a.y};
        const double own = whole_mass(set, k);
        mass += own;
        for (std::size_t i = 0; i < sums.size(); ++i)
          sums[i] += own * values[i];
      }
    std::vector<double> row{stepper.time_of_soil(), mass};
    for (const double sum : sums)
      row.push_back(mass > 0.0 ? sum / mass : 0.0);
    series_[m].second->append(row);
  }
}

} // namespace tremolo::mpm_domain
