#include "mpm_domain/fill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// Even-odd rule.
bool contains(const std::vector<Vector>& polygon, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector& a = polygon[i];
    const Vector& b = polygon[j];
    if ((a.y > y) != (b.y > y) && x < (b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x)
      inside = !inside;
  }
  return inside;
}

int count_along(double length, double size) {
  const double n = length / size;
  if (std::abs(n - std::round(n)) > 1e-6 || n < 1.0)
    throw std::invalid_argument(
        fmt::format("the model box is {:.6g} m long, which is not a multiple of the particle size {:.6g} m",
                    length, size));
  return static_cast<int>(std::lround(n));
}

void add_particle(Particles& set, std::uint32_t id, double x, double y, double size) {
  const double density = materials::elasticity(set.law).density;
  set.id.push_back(id);
  for (std::vector<double>* column : set.columns())
    column->push_back(0.0);
  set.x.back() = set.x_initial.back() = x;
  set.y.back() = set.y_initial.back() = y;
  set.volume.back() = size * size;
  set.mass.back() = density * size * size;
}

} // namespace

std::vector<Particles> fill(const Spec& spec) {
  const double size = particle_size(spec);
  const int columns = count_along(spec.box.x_max - spec.box.x_min, size);
  const int rows = count_along(spec.box.y_max - spec.box.y_min, size);

  std::vector<Particles> sets;
  for (const Soil& soil : spec.soils) {
    Particles& set = sets.emplace_back();
    set.soil = soil.name;
    set.law = soil.law;
    set.state_size = materials::state_variables(soil.law).size();
  }
  std::vector<std::uint32_t> next_id(sets.size(), 0);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = spec.box.x_min + (i + 0.5) * size;
      const double y = spec.box.y_min + (j + 0.5) * size;
      const auto region = std::find_if(spec.regions.rbegin(), spec.regions.rend(),
                                       [&](const Region& r) { return contains(r.polygon, x, y); });
      if (region != spec.regions.rend())
        add_particle(sets[region->soil], next_id[region->soil]++, x, y, size);
    }
  if (std::all_of(sets.begin(), sets.end(), [](const Particles& set) { return set.size() == 0; }))
    throw std::invalid_argument("no particle lies in any region: the domain is empty");
  for (Particles& set : sets) {
    set.state.resize(set.size() * set.state_size);
    materials::initialise(set.law, set.points(0, set.size()));
  }
  if (spec.scheme.transfer == Transfer::apic)
    for (Particles& set : sets)
      for (std::vector<double>* affine : {&set.cxx, &set.cxy, &set.cyx, &set.cyy})
        affine->assign(set.size(), 0.0);
  return sets;
}

void set_rest_stress(std::vector<Particles>& sets, const Spec& spec) {
  const double size = particle_size(spec);
  struct Place {
    double y;
    Particles* set;
    std::size_t k;
  };
  std::vector<std::vector<Place>> columns(
      static_cast<std::size_t>(std::lround((spec.box.x_max - spec.box.x_min) / size)));
  for (Particles& set : sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      columns[static_cast<std::size_t>((set.x[k] - spec.box.x_min) / size)].push_back({set.y[k], &set, k});
  for (std::vector<Place>& column : columns) {
    std::sort(column.begin(), column.end(), [](const Place& a, const Place& b) { return a.y > b.y; });
    double overburden = 0.0;
    for (const Place& place : column) {
      Particles& set = *place.set;
      const double weight = set.mass[place.k] * spec.gravity / size;
      const double k0 = materials::elasticity(set.law).rest_coefficient();
      set.syy[place.k] = -(overburden + 0.5 * weight);
      set.sxx[place.k] = set.szz[place.k] = k0 * set.syy[place.k];
      overburden += weight;
    }
  }
}

} // namespace tremolo::mpm_domain
