#include "mpm_domain/domain.hpp"

#include "mpm_domain/fill.hpp"
#include "mpm_domain/grid_growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// Cells of empty grid around the model, room for soil that moves out of its box.
constexpr int margin_cells = 6;

Grid make_grid(const Spec& spec) {
  Grid grid;
  grid.h = spec.cell_size;
  grid.x0 = spec.box.x_min - margin_cells * grid.h;
  grid.y0 = spec.box.y_min - margin_cells * grid.h;
  const auto nodes = [&](double length) {
    return static_cast<int>(std::ceil(length / grid.h - 1e-9)) + 1 + 2 * margin_cells;
  };
  resize(grid, nodes(spec.box.x_max - spec.box.x_min), nodes(spec.box.y_max - spec.box.y_min));
  if (spec.periodic_sides) {
    grid.period = static_cast<int>(std::lround((spec.box.x_max - spec.box.x_min) / grid.h));
    grid.first_column = margin_cells;
  }
  return grid;
}

const Spec& checked(const Spec& spec) {
  const auto refuse_unless = [](bool good, std::string_view what, double value, std::string_view range) {
    if (!good)
      throw std::invalid_argument(fmt::format("{} is {:.6g}; allowed: {}", what, value, range));
  };
  const double width = spec.box.x_max - spec.box.x_min;
  const double height = spec.box.y_max - spec.box.y_min;
  refuse_unless(spec.cell_size > 0.0 && std::isfinite(spec.cell_size), "the cell size (m)", spec.cell_size,
                "> 0");
  refuse_unless(width >= spec.cell_size, "the width of the model box (m)", width, "at least one cell");
  refuse_unless(std::abs(width / spec.cell_size - std::round(width / spec.cell_size)) < 1e-6,
                "the width of the model box (m)", width,
                "a multiple of the cell size, so that both sides lie on nodes");
  refuse_unless(height >= spec.cell_size, "the height of the model box (m)", height, "at least one cell");
  refuse_unless(spec.particles_per_cell >= 1 && spec.particles_per_cell <= 4,
                "particles per cell and direction", spec.particles_per_cell, "1 to 4");
  refuse_unless(spec.scheme.fraction > 0.0 && spec.scheme.fraction <= 1.0,
                "the fraction of the critical time step", spec.scheme.fraction, "in (0, 1]");
  refuse_unless(spec.scheme.transfer != Transfer::pic_blend || spec.scheme.blend_time > 0.0,
                "the time constant of the PIC blend (s)", spec.scheme.blend_time, "> 0");
  refuse_unless(spec.threads >= 1, "the number of threads", spec.threads, ">= 1");
  if (spec.soils.empty())
    throw std::invalid_argument("the domain has no soil");
  for (const Soil& soil : spec.soils)
    materials::validate(soil.law);
  return spec;
}

} // namespace

Domain::Domain(const Spec& specification)
    : spec(checked(specification)), grid(make_grid(spec)), sets(fill(spec)), faces(find_faces(sets, spec)),
      static_tractions(faces.size()), workers(spec.threads) {
  for (Particles& set : sets)
    sort_by_cell(set, grid, half_size());
}

double Domain::half_size() const {
  return 0.5 * particle_size(spec);
}

std::size_t Domain::particle_count() const {
  std::size_t count = 0;
  for (const Particles& set : sets)
    count += set.size();
  return count;
}

double Domain::fastest_wave() {
  double fastest = 0.0;
  for (Particles& set : sets)
    if (set.size() > 0)
      fastest = std::max(fastest, materials::p_wave_speed_bound(set.law, set.points(0, set.size())));
  return fastest;
}

double empty_mass(const Domain& domain) {
  constexpr double share_of_full_cell = 1e-14;
  double density = 0.0;
  for (const Particles& set : domain.sets)
    density = std::max(density, materials::elasticity(set.law).density);
  return share_of_full_cell * density * domain.grid.h * domain.grid.h;
}

double critical_time_step(Domain& domain, double max_speed) {
  return 0.65 * domain.grid.h / (domain.fastest_wave() + max_speed);
}

} // namespace tremolo::mpm_domain
