#include "mpm_domain/gravity/gravity_stage.hpp"

#include "mpm_domain/dispersion/fullness.hpp"
#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/particles/fill.hpp"
#include "mpm_domain/spec/held_nodes.hpp"
#include "mpm_domain/step/time_step.hpp"
#include "mpm_domain/tiles/cell_means.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "mpm_domain/transfer/sharp_transfer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// Steps between two looks at the residual.
constexpr long report_every = 100;

/// Which directions of a node are fixed, and which nodes carry soil.
struct Supports {
  std::vector<unsigned char> fixed_x, fixed_y, full;
  std::vector<unsigned char> met; ///< nodes that structures touch
};

/// The supports among the nodes of a lattice.
void find_supports(const Domain& domain, const Lattice& lattice, Supports& supports, Reactions& reactions) {
  const double empty = empty_mass(domain);
  for (int j = 0; j < lattice.ny; ++j)
    for (int i = 0; i < lattice.nx; ++i) {
      const std::size_t n = lattice.index(i, j);
      if (domain.grid.mass[n] <= empty)
        continue;
      supports.full[n] = 1;
      const Hold hold = hold_of(lattice, i, j, domain.spec, HeldNodes::on_lines);
      supports.fixed_y[n] = hold == Hold::all;
      supports.fixed_x[n] = hold != Hold::none;
      if (hold != Hold::none)
        (hold == Hold::all ? reactions.base : reactions.sides).push_back(n);
    }
}

Supports find_supports(const Domain& domain, Reactions& reactions) {
  const std::size_t nodes = domain.grid.size();
  Supports supports{std::vector<unsigned char>(nodes, 0), std::vector<unsigned char>(nodes, 0),
                    std::vector<unsigned char>(nodes, 0), std::vector<unsigned char>(nodes, 0)};
  for (std::size_t b = 0; b < domain.contact.bodies().size(); ++b)
    for (const ContactNode& contact : domain.contact.nodes(b)) {
      supports.met[contact.node] = 1;
      if (contact.body_mass > 0.0)
        supports.met[contact.body_node] = 1;
    }
  for (int level = 0; level < domain.lattice_count(); ++level)
    find_supports(domain, domain.lattice(level), supports, reactions);
  return supports;
}

/// One relaxation step on the grid and of the structures, which stick to the soil where they are bonded;
/// returns the residual: ||f|| over free directions by ||m g|| over all nodes. A structure's forces and those
/// of the nodes that it touches count with what contact adds to them.
double relax_grid(Domain& domain, const Supports& supports, double dt, double alpha, bool bonded) {
  Grid& grid = domain.grid;
  const double keep = (1.0 - 0.5 * alpha * dt) / (1.0 + 0.5 * alpha * dt);
  const double gain = dt / (1.0 + 0.5 * alpha * dt);
  double unbalanced = 0.0;
  double applied = 0.0;
  for (std::size_t n = 0; n < grid.size(); ++n) {
    if (!supports.full[n])
      continue;
    const double m = grid.mass[n];
    const Vector v = grid.velocity_after(n);
    const double fx = supports.fixed_x[n] ? 0.0 : grid.force_x[n];
    const double fy = supports.fixed_y[n] ? 0.0 : grid.force_y[n];
    grid.vx_after[n] = supports.fixed_x[n] ? 0.0 : keep * v.x + gain * fx / m;
    grid.vy_after[n] = supports.fixed_y[n] ? 0.0 : keep * v.y + gain * fy / m;
    if (!supports.met[n])
      unbalanced += fx * fx + fy * fy;
    applied += m * m * domain.spec.gravity * domain.spec.gravity;
  }
  if (domain.contact.any())
    unbalanced += domain.contact.relax(domain, keep, gain, bonded);
  return std::sqrt(unbalanced / applied);
}

void scatter_forces(Domain& domain) {
  domain.is_sharp() ? scatter_sharp_forces(domain) : scatter(domain, ScatterPart::force);
}

/// Strains by the velocity of the nodes.
void strain(Domain& domain, double dt) {
  if (!domain.is_sharp()) {
    gather(domain, dt, {.strain = true});
    return;
  }
  domain.grid.vx_strain = domain.grid.vx_after;
  domain.grid.vy_strain = domain.grid.vy_after;
  sharpen_strain(domain);
  gather(domain, dt, {.strain = true, .remapped = true, .sharp = true});
}

/// The geometry of a set, which stays the same under gravity.
class Geometry {
public:
  explicit Geometry(const Particles& set)
      : volume_(set.volume), box_xx_(set.box_xx), box_xy_(set.box_xy), box_yy_(set.box_yy) {}

  void restore(Particles& set) const {
    set.volume = volume_;
    set.box_xx = box_xx_;
    set.box_xy = box_xy_;
    set.box_yy = box_yy_;
  }

private:
  std::vector<double> volume_, box_xx_, box_xy_, box_yy_;
};

/// Excess pressures are means of cells, and so is the stress that pore pressure ratios are taken over.
void keep_vertical_stress(Domain& domain) {
  const CellFinder finder = domain.mesh ? CellFinder(*domain.mesh) : CellFinder(domain.tiles, 0);
  const auto over_wet = [&](const auto& act) {
    for (Particles& set : domain.sets)
      for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k)
        act(set, k, finder.at(set.x[k], set.y[k]).node);
  };
  clear_cells(domain);
  over_wet([&](const Particles& set, std::size_t k, std::size_t cell) {
    domain.grid.cell_weight[cell] += set.volume[k];
    domain.grid.cell_change[cell] += set.volume[k] * set.syy[k];
  });
  join_images_of_cells(domain);
  over_wet([&](Particles& set, std::size_t k, std::size_t cell) {
    set.vertical_at_rest[k] = mean_of_cell(domain.grid, cell);
  });
}

void add_cut(std::vector<CutStress>& cut, const std::string& soil, Vector at) {
  auto of = std::ranges::find(cut, soil, &CutStress::soil);
  if (of == cut.end())
    of = cut.insert(of, {soil, 0, at, at});
  ++of->particles;
  of->low = {std::min(of->low.x, at.x), std::min(of->low.y, at.y)};
  of->high = {std::max(of->high.x, at.x), std::max(of->high.y, at.y)};
}

/// The laws' memory begins with the stress under gravity, and with it the stiffness that the dashpots match.
/// @returns the soils whose law could not hold that stress
std::vector<CutStress> begin_history(Domain& domain) {
  std::vector<CutStress> cut;
  for (Particles& set : domain.sets) {
    const std::vector<double> before[] = {set.sxx, set.syy, set.sxy};
    materials::initialise(set.law, set.points(0, set.size()));
    for (std::size_t k = 0; k < set.size(); ++k) {
      const double change = std::abs(set.sxx[k] - before[0][k]) + std::abs(set.syy[k] - before[1][k]) +
                            std::abs(set.sxy[k] - before[2][k]);
      if (change > 1e-3 * (std::abs(before[0][k]) + std::abs(before[1][k])))
        add_cut(cut, set.soil, {set.x[k], set.y[k]});
    }
  }
  keep_vertical_stress(domain);
  domain.boundary.match(domain);
  return cut;
}

} // namespace

namespace {

/// From 0 to 1 along half of a cosine as s goes there, without a jump of velocity.
double ramped(double s) {
  return s < 1.0 ? 0.5 * (1.0 - std::cos(std::numbers::pi * s)) : 1.0;
}

/// The way that nodes go while loads come onto the ground, m.
class NodalWay {
public:
  explicit NodalWay(const Grid& grid) : x_(grid.size()), y_(grid.size()) {}

  /// Adds that of a step (s) with v+.
  void add(const Grid& grid, double dt) {
    for (std::size_t n = 0; n < x_.size(); ++n) {
      x_[n] += dt * grid.vx_after[n];
      y_[n] += dt * grid.vy_after[n];
    }
  }

  /// Lets the particles' displacement begin with it, u_p = sum S u_i: they keep their places, and have come
  /// from others.
  void count_as_displacement(Domain& domain) const {
    std::ranges::copy(x_, domain.grid.vx_after.begin());
    std::ranges::copy(y_, domain.grid.vy_after.begin());
    take_velocities_of_nodes(domain);
    for (Particles& set : domain.sets) {
      for (std::size_t k = 0; k < set.size(); ++k) {
        set.x_initial[k] -= set.vx[k];
        set.y_initial[k] -= set.vy[k];
      }
      for (std::vector<double>* field : {&set.vx, &set.vy, &set.bxx, &set.bxy, &set.byx, &set.byy})
        std::ranges::fill(*field, 0.0);
    }
    for (NodeField* field : {&domain.grid.vx_after, &domain.grid.vy_after})
      std::ranges::fill(*field, 0.0);
  }

private:
  std::vector<double> x_, y_;
};

/// Where a relaxation has ended.
struct Relaxed {
  long step;
  double residual;
};

/// Bodies that move at least a hundredth as fast as the fastest: one that slides goes on under the damping,
/// while others only answer to what it does to the soil.
std::vector<std::size_t> moving_bodies(const Domain& domain) {
  std::vector<double> speeds;
  for (std::size_t b = 0; b < domain.contact.bodies().size(); ++b)
    speeds.push_back(domain.contact.speed(domain, b));
  const double fastest = std::ranges::max(speeds);
  std::vector<std::size_t> moving;
  for (std::size_t b = 0; b < speeds.size(); ++b)
    if (speeds[b] >= 0.01 * fastest)
      moving.push_back(b);
  return moving;
}

/// Relaxes once more with structures that may slide and part from the soil, so that the shaking begins
/// without a kick. If that finds no rest, the bonded state stays.
/// @returns the bodies that move on
template <typename Relax>
std::vector<std::size_t> release(Domain& domain, const Relax& relax) {
  const std::vector<Particles> bonded = domain.sets;
  std::vector<std::size_t> moving;
  if (!relax()) {
    moving = moving_bodies(domain);
    domain.sets = bonded;
    scatter(domain, ScatterPart::force);
  }
  domain.contact.end_rest();
  return moving;
}

} // namespace

Reactions bring_to_rest(Domain& domain, const GravitySettings& settings, std::span<const LoadSettings> loads,
                        const StageProgress& progress) {
  if (!(domain.spec.gravity > 0.0))
    throw std::invalid_argument(
        fmt::format("a gravity stage needs gravity > 0; it is {:.6g} m/s2", domain.spec.gravity));
  set_rest_stress(domain.sets_of_soil(), domain.spec);
  std::vector<materials::Law> laws;
  for (Particles& set : domain.sets) {
    laws.push_back(set.law);
    set.law = materials::without_softening(set.law);
    set.damping_time = 0.0; // relaxation has a damping of its own, on mass
  }
  const std::vector<Geometry> given(domain.sets.begin(), domain.sets.end());

  scatter(domain, ScatterPart::motion);
  if (domain.is_sharp())
    find_fullness(domain);
  domain.contact.begin_rest(domain);
  for (NodeField* velocity : {&domain.grid.vx_after, &domain.grid.vy_after})
    std::fill(velocity->begin(), velocity->end(), 0.0);
  Reactions reactions;
  const Supports supports = find_supports(domain, reactions);
  const double depth = domain.spec.box.y_max - domain.spec.box.y_min;
  double slowest = domain.fastest_wave();
  for (const Particles& set : domain.sets)
    slowest = std::min(slowest, materials::elasticity(set.law).s_wave_speed());
  const double alpha = std::numbers::pi * slowest / depth;
  const double dt = domain.spec.scheme.fraction * critical_skeleton_step(domain); // pore pressures stay

  for (const LoadSettings& load : loads)
    domain.loads.scale(load.load, 0.0);
  domain.loads.follow(domain);
  NodalWay way(domain.grid);
  std::size_t stage = 0;
  /// @param load  that grows; null: none
  const auto relax = [&](bool bonded, long first, double time, double residual, const LoadSettings* load) {
    Relaxed relaxed{first, 0.0};
    for (long step = first;; ++step) {
      const double passed = static_cast<double>(step - first) * dt;
      if (load != nullptr && passed < load->ramp + dt) {
        domain.loads.scale(load->load, ramped(passed / load->ramp));
        domain.loads.follow(domain);
      }
      scatter_forces(domain);
      domain.loads.add(domain.grid);
      relaxed = {step, relax_grid(domain, supports, dt, alpha, bonded)};
      prolong(domain, NodeGroup::velocity);
      const bool grows = load != nullptr && passed < load->ramp;
      const bool ends = !grows && (relaxed.residual < residual || !(passed < time));
      if (ends || step % report_every == 0)
        progress(stage, step, relaxed.residual);
      if (ends)
        return relaxed;
      if (load != nullptr)
        way.add(domain.grid, dt);
      strain(domain, dt);
      // Geometry is given: volumes, boxes and places do not change.
      for (std::size_t s = 0; s < domain.sets.size(); ++s)
        given[s].restore(domain.sets[s]);
    }
  };
  const Relaxed rest = relax(true, 0, settings.max_time, settings.residual, nullptr);
  if (!(rest.residual < settings.residual))
    throw NotAtRest(fmt::format(
        "the gravity stage did not come to rest: residual {:.3g} after {:.3g} s of relaxation, wanted "
        "{:.3g}; the slope may not be stable under its weight, which tremolo safety finds out",
        rest.residual, settings.max_time, settings.residual));
  if (domain.contact.any())
    reactions.slipping_bodies = release(domain, [&] {
      constexpr long least =
          1000; // steps that friction may take to find its share, and as often those of the bonds
      const double time = static_cast<double>(std::max(least, 4 * rest.step)) * dt;
      return relax(false, rest.step, time, settings.residual, nullptr).residual < settings.residual;
    });
  for (const LoadSettings& load : loads) {
    ++stage;
    const double time = load.ramp + load.max_time;
    const Relaxed loaded = relax(false, 0, time, load.residual, &load);
    if (!(loaded.residual < load.residual))
      throw NotAtRest(fmt::format(
          "the ground did not come to rest under the load from x = {:.6g} to {:.6g} m: residual {:.3g} after "
          "{:.3g} s of relaxation, wanted {:.3g}; it may not carry the load",
          domain.spec.loads[load.load].x_min, domain.spec.loads[load.load].x_max, loaded.residual, time,
          load.residual));
  }

  reactions.slipping = !reactions.slipping_bodies.empty();
  reactions.force.assign(domain.grid.size(), Vector{});
  for (const std::size_t n : reactions.base)
    reactions.force[n] = {-domain.grid.force_x[n], -domain.grid.force_y[n]};
  for (const std::size_t n : reactions.sides)
    reactions.force[n] = {-domain.grid.force_x[n], 0.0};
  for (std::size_t s = 0; s < domain.sets.size(); ++s) {
    Particles& set = domain.sets[s];
    set.law = laws[s];
    if (!set.body)
      set.damping_time = domain.spec.soils[set.soil_index].damping_time;
  }
  if (!loads.empty())
    way.count_as_displacement(domain);
  reactions.cut = begin_history(domain);
  return reactions;
}

Reactions relax_under_gravity(Domain& domain, const GravitySettings& settings,
                              const GravityProgress& progress) {
  return bring_to_rest(domain, settings, {},
                       [&](std::size_t, long step, double residual) { progress(step, residual); });
}

void take_velocities_of_nodes(Domain& domain) {
  for (Particles& set : domain.sets) {
    std::ranges::fill(set.vx, 0.0);
    std::ranges::fill(set.vy, 0.0);
  }
  std::ranges::fill(domain.grid.vx_before, 0.0); // FLIP adds what nodes have gained since
  std::ranges::fill(domain.grid.vy_before, 0.0);
  gather(domain, 0.0, {.velocity = true});
}

} // namespace tremolo::mpm_domain
