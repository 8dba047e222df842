#include "mpm_domain/domain.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/particles/fill.hpp"
#include "mpm_domain/particles/grid_growth.hpp"
#include "mpm_domain/spec/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

Grid make_grid(const Spec& spec) {
  Grid grid;
  static_cast<GridShape&>(grid) = grid_shape(spec.box, spec.cell_size, spec.sides);
  resize_fields(grid, grid.count());
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
  if (spec.scheme.subcycle && (spec.refine.empty() || spec.scheme.transfer != Transfer::apic ||
                               spec.scheme.order != StepOrder::musl || spec.sides == Sides::periodic_springs))
    throw std::invalid_argument("sub-cycling needs a refined mesh, the transfer apic, the order musl, "
                                "and sides without springs");
  refuse_unless(spec.threads >= 1, "the number of threads", spec.threads, ">= 1");
  if (spec.soils.empty())
    throw std::invalid_argument("the domain has no soil");
  for (const Soil& soil : spec.soils)
    materials::validate(soil.law);
  return spec;
}

} // namespace

std::size_t blocks_of(const Lattice& lattice) {
  return static_cast<std::size_t>((lattice.ny + rows_per_block - 1) / rows_per_block);
}

void rebuild_mesh(Domain& domain) {
  const Spec& spec = domain.spec;
  if (spec.refine.empty()) {
    domain.images = images_of(domain.grid);
    return;
  }
  domain.mesh.emplace(roots_of(domain.grid),
                      refinements_of(spec.refine, spec.box, spec.cell_size, spec.sides));
  domain.basis_cells = {};
  domain.across.clear();
  if (spec.scheme.subcycle)
    domain.clocks = ClockMap(domain.mesh->tree(), buffer_layers);
  resize_fields(domain.grid, domain.mesh->node_count());
}

void keep_whole(Domain& domain, std::size_t set, std::uint32_t id) {
  std::vector<std::uint32_t>& whole = domain.sets[set].whole;
  const auto at = std::ranges::lower_bound(whole, id);
  if (at == whole.end() || *at != id)
    whole.insert(at, id);
}

void sort_particles(Domain& domain) {
  for (std::size_t s = 0; s < domain.sets.size(); ++s)
    if (domain.mesh)
      sort_by_lattice(domain.sets[s], *domain.mesh, domain.clocks, domain.sort_distance());
    else
      sort_by_cell(domain.sets[s], domain.grid);
  resize_fields(domain.grid, domain.grid.size());
  domain.boundary.find_levels(domain);
  find_reach(domain);
}

namespace {

void find_across(Domain& domain, const GradedMesh& mesh) {
  const std::size_t sets = domain.sets.size();
  const std::size_t levels = mesh.lattices().size();
  domain.across.resize(sets * static_cast<std::size_t>(domain.clocks.count()));
  for (std::size_t n = 0; n < domain.across.size(); ++n) {
    const Particles& set = domain.sets[n % sets];
    const std::size_t block = domain.block_count() + n / sets * levels;
    domain.across[n].restart(set.block_start[block]);
    for (std::size_t k = set.block_start[block]; k < set.block_start[block + levels]; ++k)
      domain.across[n].expect(mesh, domain.basis_cells, reach_of(set, k, domain.sort_distance()));
  }
}

} // namespace

void find_reach(Domain& domain) {
  if (domain.mesh)
    find_across(domain, *domain.mesh);
  domain.soil_rows = find_soil_rows(domain);
  weigh_across(domain);
}

void weigh_across(Domain& domain, int slowest_clock) {
  const std::size_t sets = domain.sets.size();
  const std::size_t skipped = sets * static_cast<std::size_t>(slowest_clock);
  if (domain.across.size() <= skipped)
    return;
  domain.workers.run(domain.across.size() - skipped, [&](std::size_t task) {
    const std::size_t n = skipped + task;
    AcrossWeights& weights = domain.across[n];
    weights.clear();
    for (std::size_t k = weights.first(); k < weights.end(); ++k)
      weights.add(domain.basis_cells, box_of(domain.sets[n % sets], k));
  });
}

Domain::Domain(const Spec& specification)
    : spec(checked(specification)), grid(make_grid(spec)), workers(spec.threads) {
  rebuild_mesh(*this);
  sets = fill(spec, mesh ? &mesh->tree() : nullptr);
  boundary.match(sets, spec);
  for (const BoundaryFace& face : boundary.faces())
    keep_whole(*this, face.set, face.id);
  sort_particles(*this);
}

double Domain::half_size(int level) const {
  return 0.5 * particle_size(spec, level);
}

std::size_t Domain::blocks_per_clock() const {
  std::size_t count = 0;
  for (int level = 0; level < lattice_count(); ++level)
    count += blocks_of(lattice(level));
  return count;
}

int Domain::clock_of_block(std::size_t block) const {
  const std::size_t blocks = block_count();
  return static_cast<int>(block < blocks ? block / blocks_per_clock()
                                         : (block - blocks) / static_cast<std::size_t>(lattice_count()));
}

int Domain::lattice_of_block(std::size_t block) const {
  block %= blocks_per_clock();
  int level = 0;
  while (block >= blocks_of(lattice(level)))
    block -= blocks_of(lattice(level++));
  return level;
}

std::size_t Domain::row_count() const {
  std::size_t count = 0;
  for (int level = 0; level < lattice_count(); ++level)
    count += static_cast<std::size_t>(lattice(level).ny);
  return count;
}

NodeRange Domain::row(std::size_t row) const {
  int level = 0;
  while (row >= static_cast<std::size_t>(lattice(level).ny))
    row -= static_cast<std::size_t>(lattice(level++).ny);
  const std::size_t begin = lattice(level).index(0, static_cast<int>(row));
  return {begin, begin + static_cast<std::size_t>(lattice(level).nx)};
}

double Domain::sort_distance() const {
  return mesh ? across_margin * finest_lattice().h : sort_cells * grid.h;
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
  constexpr double share_of_full_cell = 1e-20;
  double density = 0.0;
  for (const Particles& set : domain.sets)
    density = std::max(density, materials::elasticity(set.law).density);
  const double h = domain.finest_lattice().h;
  return share_of_full_cell * density * h * h;
}

} // namespace tremolo::mpm_domain
