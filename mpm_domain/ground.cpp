#include "mpm_domain/ground.hpp"

#include "mesh/cell_size.hpp"
#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/head/seepage_of_ground.hpp"
#include "mpm_domain/particles/fill/fill.hpp"
#include "mpm_domain/particles/fill/fill_bodies.hpp"
#include "mpm_domain/particles/fill/fill_together.hpp"
#include "mpm_domain/particles/room.hpp"
#include "mpm_domain/particles/share_out.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/particles/wave_speed.hpp"
#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/spec/conflicts.hpp"
#include "mpm_domain/spec/limits.hpp"
#include "mpm_domain/tiles/totals.hpp"
#include "mpm_domain/transfer/out_of_reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

Grid make_grid(const Spec& spec) {
  Grid grid;
  static_cast<GridShape&>(grid) = grid_shape(spec.box, spec.cell_size, spec.sides);
  resize_fields(grid, grid.count());
  return grid;
}

/// A structure or lining meets each soil with friction and adhesion.
template <class Body>
void check_contact(const char* kind, const Body& body, const Spec& spec) {
  if (body.friction.size() != spec.soils.size() || body.adhesion.size() != spec.soils.size())
    throw std::invalid_argument(fmt::format("{} '{}' needs friction and adhesion for each of {} soils", kind,
                                            body.name, spec.soils.size()));
}

int finest_level(const Spec& spec) {
  int finest = 0;
  for (const mesh::Refinement& refine : spec.refine)
    finest = std::max(finest, refine.level);
  return finest;
}

/// A box around an outline and two of the finest cells beside it, m.
Box room_around(const std::vector<Vector>& outline, const Spec& spec) {
  const double margin = 2.0 * mesh::cell_size(spec.cell_size, finest_level(spec));
  Box box{outline.front().x, outline.front().y, outline.front().x, outline.front().y};
  for (const Vector& corner : outline)
    box = {std::min(box.x_min, corner.x), std::min(box.y_min, corner.y), std::max(box.x_max, corner.x),
           std::max(box.y_max, corner.y)};
  return {box.x_min - margin, box.y_min - margin, box.x_max + margin, box.y_max + margin};
}

/// A lining meets soil on the finest cells, and touches no node of a side or of what else stands in the soil.
void check_room_of(const Lining& lining, const Spec& spec) {
  if (lining.outline.empty())
    throw std::invalid_argument(fmt::format("lining '{}' has no outline", lining.name));
  const Box room = room_around(lining.outline, spec);
  if (room.x_min < spec.box.x_min || room.x_max > spec.box.x_max || room.y_min < spec.box.y_min)
    throw std::invalid_argument(
        fmt::format("lining '{}' comes within two cells of the sides or the base of the "
                    "model: a model that is larger by that much holds it",
                    lining.name));
  const int finest = finest_level(spec);
  bool on_finest = spec.refine.empty();
  for (const auto& [box, level] : spec.refine)
    on_finest |= level == finest && box.x_min <= room.x_min && box.y_min <= room.y_min &&
                 box.x_max >= room.x_max && box.y_max >= std::min(room.y_max, spec.box.y_max);
  if (!on_finest)
    throw std::invalid_argument(
        fmt::format("lining '{}' comes within two cells of cells larger than the finest: "
                    "it meets soil on the finest alone",
                    lining.name));
  const auto refuse_near = [&](const std::string& name, const std::vector<Vector>& outline) {
    const Box other = room_around(outline, spec);
    if (other.x_min < room.x_max && other.x_max > room.x_min && other.y_min < room.y_max &&
        other.y_max > room.y_min)
      throw std::invalid_argument(fmt::format("the boxes around lining '{}' and around '{}' come within four "
                                              "cells of each other: both would meet the same soil",
                                              lining.name, name));
  };
  for (const Structure& structure : spec.structures)
    refuse_near(structure.name, structure.outline);
  for (const Lining& other : spec.linings)
    if (&other != &lining)
      refuse_near(other.name, other.outline);
}

/// Holes of elastic structures are dry.
void check_holes(const Spec& spec, const std::optional<Head>& head) {
  for (const Structure& structure : spec.structures)
    if (structure.stiffness && head && std::ranges::any_of(structure.hole, [&](const Vector& corner) {
          return head->is_wet(corner.x, corner.y);
        }))
      throw std::invalid_argument(
          fmt::format("the hole of structure '{}' reaches below the water table: it must be rigid there",
                      structure.name));
}

/// Loads lie inside the model, on soil that no structure covers.
template <typename RefuseUnless>
void check_loads(const Spec& spec, const RefuseUnless& refuse_unless) {
  for (const SurfaceLoad& load : spec.loads) {
    refuse_unless(load.x_min >= spec.box.x_min && load.x_min < spec.box.x_max,
                  "the left end of a load on the surface (m)", load.x_min, "inside the model");
    refuse_unless(load.x_max > load.x_min && load.x_max <= spec.box.x_max,
                  "the right end of a load on the surface (m)", load.x_max,
                  "inside the model and beyond the left end");
    refuse_unless(load.pressure >= 0.0 && std::isfinite(load.pressure), "the pressure of a load (Pa)",
                  load.pressure, "finite, >= 0");
    refuse_unless(std::isfinite(load.shear), "the shear of a load (Pa)", load.shear, "finite");
  }
  for (const Structure& structure : spec.structures) {
    const auto [left, right] = std::ranges::minmax(structure.outline, {}, &Vector::x);
    for (const SurfaceLoad& load : spec.loads)
      if (load.x_min < right.x && load.x_max > left.x)
        throw std::invalid_argument(fmt::format(
            "a load from x = {:.6g} to {:.6g} m lies where structure '{}' is: it acts on soil alone",
            load.x_min, load.x_max, structure.name));
  }
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
  refuse_conflicts(spec);
  refuse_unless(spec.threads >= 1, "the number of threads", spec.threads, ">= 1");
  if (spec.soils.empty())
    throw std::invalid_argument("the domain has no soil");
  for (const Soil& soil : spec.soils) {
    materials::validate(soil.law);
    refuse_unless(soil.damping_time >= 0.0 && std::isfinite(soil.damping_time),
                  fmt::format("the damping time of soil '{}' (s)", soil.name), soil.damping_time,
                  "finite, >= 0");
    refuse_unless(soil.mass_damping >= 0.0 && std::isfinite(soil.mass_damping),
                  fmt::format("the damping of soil '{}' in proportion to mass (1/s)", soil.name),
                  soil.mass_damping, "finite, >= 0");
    if (spec.water && soil.pores)
      materials::validate(*soil.pores);
  }
  for (const Structure& structure : spec.structures)
    check_contact("structure", structure, spec);
  for (const Lining& lining : spec.linings) {
    check_contact("lining", lining, spec);
    check_room_of(lining, spec);
  }
  check_loads(spec, refuse_unless);
  if (spec.water) {
    materials::validate(spec.water->fluid);
    refuse_unless(spec.gravity > 0.0, "gravity above a water table (m/s2)", spec.gravity, "> 0");
  }
  return spec;
}

/// The rows among these whose tied nodes are one other node, a period away.
std::vector<std::size_t> rows_of_images(const Prolongation& ties, std::span<const std::size_t> of) {
  std::vector<std::size_t> rows;
  for (const std::size_t row : of)
    if (const auto shares = ties.row(row); shares.size() == 1 && shares.front().dx != 0.0)
      rows.push_back(row);
  return rows;
}

} // namespace

void rebuild_mesh(Ground& ground) {
  const Spec& spec = ground.spec;
  if (spec.refine.empty()) {
    ground.images = images_of(ground.grid);
  } else {
    ground.mesh.emplace(roots_of(ground.grid),
                        refinements_of(spec.refine, spec.box, spec.cell_size, spec.sides));
    ground.basis_cells = {};
    if (spec.scheme.subcycle)
      ground.clocks = ClockMap(ground.mesh->tree(), buffer_layers);
  }
  lay_out_lattices(ground);
}

void keep_whole(Ground& ground, std::size_t set, std::uint32_t id) {
  std::vector<std::uint32_t>& whole = ground.sets[set].whole;
  const auto at = std::ranges::lower_bound(whole, id);
  if (at == whole.end() || *at != id)
    whole.insert(at, id);
}

void order_particles(Ground& ground) {
  follow_bodies(ground);
  if (ground.share)
    move_between_ranks(ground);
  const std::size_t blocks = ground.block_count() + ground.across_block_count();
  for (Particles& set : ground.sets)
    if (set.body)
      sort_by_cell(set, ground.tiles, ground.soil_lattice_count() + static_cast<int>(*set.body), blocks);
    else if (ground.mesh)
      sort_by_lattice(set, *ground.mesh, ground.tiles, ground.clocks, ground.sort_distance());
    else
      sort_by_cell(set, ground.tiles, 0, blocks);
  resize_fields(ground.grid, ground.grid.size());
}

namespace {

/// The tiles with particles of a clock on one lattice.
std::vector<std::size_t> filled_tiles(const Ground& ground, int clock) {
  std::vector<std::size_t> filled;
  for (std::size_t tile = 0; tile < ground.tiles.count(); ++tile)
    if (std::ranges::any_of(ground.sets, [&](const Particles& set) {
          const auto [begin, end] = set.in_block(ground.block(clock, tile));
          return begin < end;
        }))
      filled.push_back(tile);
  return filled;
}

/// Finds the tiles in which other ranks have such particles.
/// @param own  tiles in which this rank has some
std::vector<std::size_t> filled_by_others(const Ground& ground, std::span<const std::size_t> own) {
  std::vector<std::size_t> others;
  if (!ground.share)
    return others;
  std::vector<std::int64_t> is_filled(ground.tiles.count(), 0);
  for (const std::size_t tile : own)
    is_filled[tile] = 1;
  ground.share->ranks->add(is_filled);
  for (std::size_t tile = 0; tile < is_filled.size(); ++tile)
    if (is_filled[tile] > 0 && !ground.share->is_mine(tile))
      others.push_back(tile);
  return others;
}

std::vector<AcrossTile> find_across(Ground& ground, int clock) {
  std::vector<AcrossTile> across;
  for (std::size_t s = 0; s < ground.sets.size(); ++s)
    for (std::size_t tile = 0; tile < ground.tiles.count(); ++tile) {
      const Particles& set = ground.sets[s];
      const auto [begin, end] = set.in_block(ground.across_block(clock, tile));
      if (begin == end)
        continue;
      AcrossTile& found = across.emplace_back(AcrossTile{tile, s, {}, {}});
      found.weights.restart(begin);
      for (std::size_t k = begin; k < end; ++k)
        found.weights.expect(*ground.mesh, ground.basis_cells, reach_of(set, k, ground.sort_distance()));
      found.weights.settle(ground.basis_cells);
      const std::size_t fields = ground.has_water() ? particle_sums.size() : dry_sums.end;
      found.sums.resize(fields * found.weights.fours().size() * 4);
    }
  return across;
}

} // namespace

void find_reach(Ground& ground, std::span<const std::size_t> shared_nodes) {
  ground.windows.reserve(2 * ground.tiles.most_columns()); // those of two rows of tiles are in use at a time
  ground.clock_tiles.clear();
  for (int clock = 0; clock < ground.clocks.count(); ++clock) {
    std::vector<std::size_t> filled = filled_tiles(ground, clock);
    const std::vector<std::size_t> of_others = filled_by_others(ground, filled);
    ground.clock_tiles.push_back(
        {TileSums(ground.tiles, std::move(filled), ground.share ? &*ground.share : nullptr, of_others),
         ground.mesh ? find_across(ground, clock) : std::vector<AcrossTile>{}});
  }
  ground.skirt.reset();
  std::vector<std::size_t> more(shared_nodes.begin(), shared_nodes.end());
  if (ground.share && ground.is_sharp()) {
    ground.skirt.emplace(ground, shared_nodes);
    more.insert(more.end(), ground.skirt->nodes().begin(), ground.skirt->nodes().end());
  }
  ground.soil_rows = find_soil_rows(ground, more);
  ground.soil_ties = find_soil_ties(ground);
  ground.image_rows = rows_of_images(ground.ties(), ground.soil_ties);
  weigh_across(ground);
}

void weigh_across(Ground& ground, int slowest_clock) {
  std::vector<AcrossTile*> due;
  for (auto clock = static_cast<std::size_t>(slowest_clock); clock < ground.clock_tiles.size(); ++clock)
    for (AcrossTile& tile : ground.clock_tiles[clock].across)
      due.push_back(&tile);
  ground.workers.run(due.size(), [&](std::size_t task) {
    AcrossWeights& weights = due[task]->weights;
    weights.clear();
    for (std::size_t k = weights.first(); k < weights.end(); ++k)
      if (const Particles& p = ground.sets[due[task]->set]; !weights.add(ground.basis_cells, box_of(p, k)))
        refuse_stray(p, k, ground.sort_distance());
  });
}

namespace {

/// Whether something is so on any rank.
bool is_anywhere(const Ground& ground, bool is_here) {
  double number = is_here ? 1.0 : 0.0;
  take_largest(ground, {&number, 1});
  return number > 0.0;
}

} // namespace

Ground::Ground(const Spec& specification, Communicator* ranks)
    : spec(checked(specification)), head(head_of(spec)), grid(make_grid(spec)), workers(spec.threads) {
  check_holes(spec, head);
  rebuild_mesh(*this);
  const mesh::Quadtree* const tree = mesh ? &mesh->tree() : nullptr;
  sets = ranks != nullptr ? fill_together(spec, head, tree, *ranks) : fill(spec, head, tree);
  soil_sets = sets.size();
  for (Particles& set : sets)
    spread_out(set);
  if (ranks != nullptr)
    share.emplace(RankShare{.ranks = ranks, .deal = {}});
  for (Particles& set : fill_bodies(spec, head, soil_lattice_count() - 1)) {
    bodies.resize(*set.body + 1);
    sets.push_back(std::move(set));
  }
  grid.traits.sharp = spec.scheme.dispersion == Dispersion::reduced;
  for (const Particles& set : sets) {
    grid.traits.wet |= set.water && set.size() > 0;
    grid.traits.flowing |= set.traits.flowing && set.size() > 0;
  }
  grid.traits.wet = is_anywhere(*this, grid.traits.wet);
  grid.traits.flowing = is_anywhere(*this, grid.traits.flowing);
  if (head)
    take_head(*this, *head);
  waiting_strains.resize(sets.size());
  waiting_pressures.resize(sets.size());
}

Ground::~Ground() = default;

std::span<const Particles> Ground::sets_of_body(std::size_t body) const {
  const std::span<const Particles> all = body_sets();
  return {std::ranges::lower_bound(all, std::optional(body), {}, &Particles::body),
          std::ranges::upper_bound(all, std::optional(body), {}, &Particles::body)};
}

bool Ground::has_pore_pressure() const {
  return std::ranges::any_of(sets,
                             [](const Particles& set) { return set.traits.wet && !set.index_of.empty(); });
}

double Ground::half_size(int level) const {
  return 0.5 * particle_size(spec, level);
}

std::size_t Ground::row_count() const {
  std::size_t count = 0;
  for (int level = 0; level < lattice_count(); ++level)
    count += static_cast<std::size_t>(lattice(level).ny);
  return count;
}

NodeRange Ground::row(std::size_t row) const {
  int level = 0;
  while (row >= static_cast<std::size_t>(lattice(level).ny))
    row -= static_cast<std::size_t>(lattice(level++).ny);
  const std::size_t begin = lattice(level).index(0, static_cast<int>(row));
  return {begin, begin + static_cast<std::size_t>(lattice(level).nx)};
}

bool Ground::has_structures_here() const {
  return !share || share->ranks->rank() == 0;
}

NodePosition Ground::position_of(std::size_t node) const {
  int level = 0;
  while (node >= lattice(level).first + lattice(level).count())
    ++level;
  const Lattice& of = lattice(level);
  const auto columns = static_cast<std::size_t>(of.nx);
  const auto column = static_cast<int>((node - of.first) % columns);
  const auto row = static_cast<int>((node - of.first) / columns);
  return {level, column, row, {of.x0 + column * of.h, of.y0 + row * of.h}};
}

bool Ground::counts(const NodeRange& nodes) const {
  if (!share)
    return true;
  const NodePosition position = position_of(nodes.begin);
  return share->is_mine(tiles.tile_of(position.level, position.column, position.row));
}

double Ground::sort_distance() const {
  return mesh ? across_margin * finest_lattice().h : (is_sharp() ? sharp_sort_cells : sort_cells) * grid.h;
}

double Ground::reach_of_structures() const {
  return 4.0 * finest_lattice().h + 2.0 * sort_distance();
}

std::size_t Ground::particle_count() const {
  std::size_t count = 0;
  for (const Particles& set : sets)
    count += set.size();
  return count;
}

double Ground::fastest_wave() {
  double fastest = 0.0;
  for (Particles& set : sets)
    if (set.size() > 0)
      fastest = std::max(fastest, fastest_waves(set, {0, set.size()}).in_soil);
  return fastest;
}

double empty_mass(const Ground& ground) {
  constexpr double share_of_full_cell = 1e-20;
  double density = 0.0;
  for (const Particles& set : ground.sets)
    density = std::max(density, materials::elasticity(set.law).density);
  const double h = ground.finest_lattice().h;
  return share_of_full_cell * density * h * h;
}

void follow_clock(Ground& ground, double time) {
  const materials::SoilClock& clock = ground.spec.clock;
  if (!clock.has_rested(time))
    return;
  const bool rests = clock.rests(time);
  for (Particles& set : ground.sets_of_soil()) {
    set.law = rests ? materials::after_shaking(set.law) : materials::shaken_again(set.law);
    if (set.water)
      set.water->pores.permeability =
          clock.speed(time) * ground.spec.soils[set.soil_index].pores->permeability;
  }
}

void take_head(Ground& ground, Head head) {
  ground.head = std::move(head);
  for (Particles& set : ground.sets)
    if (set.water)
      take_head(set, *ground.head);
  ground.grid.traits.seeping = is_anywhere(ground, std::ranges::any_of(ground.sets, [](const Particles& set) {
                                             return set.traits.seeping && set.size() > 0;
                                           }));
  resize_fields(ground.grid, ground.grid.size());
}

double particle_updates_per_step(const Ground& ground) {
  double updates = 0.0;
  if (ground.share) {
    for (const std::int64_t of_tile : ground.share->updates)
      updates += static_cast<double>(of_tile);
    return updates;
  }
  const std::size_t tiles = ground.tiles.count();
  for (const Particles& set : ground.sets)
    for (int clock = 0; clock < ground.clocks.count(); ++clock) {
      const auto count = [&](std::size_t first_block) {
        return static_cast<double>(set.block_start[first_block + tiles] - set.block_start[first_block]);
      };
      const double across = ground.mesh ? count(ground.across_block(clock, 0)) : 0.0;
      updates += (count(ground.block(clock, 0)) + across) * static_cast<double>(1 << clock);
    }
  return updates;
}

} // namespace tremolo::mpm_domain
