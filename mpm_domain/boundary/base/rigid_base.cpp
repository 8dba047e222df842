#include "mpm_domain/boundary/base/rigid_base.hpp"

#include "mpm_domain/clocks/ticks.hpp"
#include "mpm_domain/ground.hpp"
#include "mpm_domain/spec/held_nodes.hpp"
#include "mpm_domain/tiles/totals.hpp"

#include <array>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

Vector after(Vector start, double time, Vector rate) {
  return {std::fma(time, rate.x, start.x), std::fma(time, rate.y, start.y)};
}

/// Sum over the nodes of these rows.
template <typename OfNode>
ExactSums<1> sum_over(Ground& ground, std::span<const NodeRange> rows, const OfNode& of_node) {
  return sum_over_rows<1>(ground, rows, [&](const NodeRange& row) {
    double sum = 0.0;
    for (std::size_t n = row.begin; n < row.end; ++n)
      sum += of_node(n);
    return std::array{sum};
  });
}

/// Mass of a node with the water that flows in it, kg/m.
class MassOfAll {
public:
  explicit MassOfAll(const Ground& ground) : nodes_(ground.grid), flows_(ground.has_flow()) {}
  double operator()(std::size_t n) const { return nodes_.mass[n] + (flows_ ? nodes_.water_mass[n] : 0.0); }

private:
  const NodeFields& nodes_;
  bool flows_;
};

/// Density of the water where it flows, kg/m3, or nothing.
double density_of_flow(const Ground& ground) {
  return ground.has_flow() ? ground.spec.water->fluid.density : 0.0;
}

/// Adds a force per volume of water (N/m3) to that on the water of these nodes.
void pull_water(NodeFields& nodes, const NodeRange& row, Vector force) {
  for (std::size_t n = row.begin; n < row.end; ++n) {
    nodes.water_force_x[n] += nodes.wet_volume[n] * force.x;
    nodes.water_force_y[n] += nodes.wet_volume[n] * force.y;
  }
}

} // namespace

RigidBase::RigidBase(const Ground& ground, std::span<BoundaryFace> faces) {
  for (BoundaryFace& face : faces)
    face.behind.has_dashpots = false;
  seen_.resize(static_cast<std::size_t>(ground.clocks.count()));
  follow_sort(ground);
}

void RigidBase::follow_sort(const Ground& ground) {
  all_.clear();
  across_.clear();
  for (int level = 0; level < ground.lattice_count(); ++level) {
    const Lattice& lattice = ground.lattice(level);
    for (int j = 0; j < lattice.ny; ++j)
      for (int i = 0; i < lattice.nx; ++i)
        if (const Hold hold = hold_of(lattice, i, j, ground.spec, HeldNodes::on_and_behind);
            hold != Hold::none)
          (hold == Hold::all ? all_ : across_).push_back(lattice.index(i, j));
  }
}

void RigidBase::stop(Ground& ground) const {
  NodeFields& nodes = ground.grid;
  for (const std::size_t n : all_)
    nodes.momentum_x[n] = nodes.momentum_y[n] = 0.0;
  for (const std::size_t n : across_)
    nodes.momentum_x[n] = 0.0;
  if (!ground.has_flow())
    return;
  for (const std::size_t n : all_)
    nodes.water_momentum_x[n] = nodes.water_momentum_y[n] = 0.0;
  for (const std::size_t n : across_)
    nodes.water_momentum_x[n] = 0.0;
}

void RigidBase::close_to_water(NodeFields& nodes) const {
  for (const std::size_t n : all_)
    nodes.open_x[n] = nodes.open_y[n] = 0.0;
  for (const std::size_t n : across_)
    nodes.open_x[n] = 0.0;
}

void RigidBase::bear(NodeFields& nodes) const {
  for (const std::size_t n : all_)
    nodes.force_x[n] = nodes.force_y[n] = 0.0;
  for (const std::size_t n : across_)
    nodes.force_x[n] = 0.0;
}

void RigidBase::exchange(const Exchange& at, std::span<SupportLoad>) {
  const Vector velocity = at.field.front().velocity;
  if (dt_ > 0.0) {
    displacement_ = after(displacement_, dt_, seen_.front().velocity);
    rate_ = (velocity - velocity_) / dt_;
  }
  velocity_ = velocity;
  dt_ = at.dt;
}

void RigidBase::push(Ground& ground, const Ticks& ticks, int clock, std::span<const NodeRange> rows) {
  const double time = ticks.now() * ticks.dt_of(ticks.clocks() - 1) + 0.5 * ticks.dt_of(clock);
  const double kick = ticks.kick_of(clock);
  Seen& seen = seen_[static_cast<std::size_t>(clock)];
  const Vector next = after(velocity_, time, rate_);
  const Vector a = (next - seen.velocity) / kick;
  seen = {next, a};
  NodeFields& nodes = ground.grid;
  const MassOfAll mass(ground);
  const double density = density_of_flow(ground);
  ground.workers.run(rows.size(), [&](std::size_t row) {
    for (std::size_t n = rows[row].begin; n < rows[row].end; ++n) {
      nodes.force_x[n] -= mass(n) * a.x;
      nodes.force_y[n] -= mass(n) * a.y;
    }
    if (density > 0.0)
      pull_water(nodes, rows[row], {-density * a.x, -density * a.y});
  });
  bear(nodes);
}

void RigidBase::release_water(Ground& ground, int clock, std::span<const NodeRange> rows) const {
  const Vector a = seen_[static_cast<std::size_t>(clock)].acceleration;
  const double density = density_of_flow(ground);
  ground.workers.run(rows.size(), [&](std::size_t row) { pull_water(ground.grid, rows[row], density * a); });
}

ExactSums<1> RigidBase::power(Ground& ground, int clock, std::span<const NodeRange> rows) const {
  const NodeFields& nodes = ground.grid;
  const Vector a = seen_[static_cast<std::size_t>(clock)].acceleration;
  const bool flows = ground.has_flow();
  return sum_over(ground, rows, [&](std::size_t n) {
    const double of_soil = nodes.mass[n] * (a.x * (nodes.vx_before[n] + nodes.vx_after[n]) +
                                            a.y * (nodes.vy_before[n] + nodes.vy_after[n]));
    const double of_water = flows ? nodes.water_mass[n] * (a.x * (nodes.wx_before[n] + nodes.wx_after[n]) +
                                                           a.y * (nodes.wy_before[n] + nodes.wy_after[n]))
                                  : 0.0;
    return -0.5 * (of_soil + of_water);
  });
}

ExactSums<1> RigidBase::remap_power(Ground& ground, int clock, std::span<const NodeRange> rows) const {
  const NodeFields& nodes = ground.grid;
  const Vector a = seen_[static_cast<std::size_t>(clock)].acceleration;
  const MassOfAll mass(ground);
  return sum_over(ground, rows, [&](std::size_t n) {
    return mass(n) *
           (a.x * (nodes.vx_strain[n] - nodes.vx_after[n]) + a.y * (nodes.vy_strain[n] - nodes.vy_after[n]));
  });
}

BaseMotion RigidBase::motion() const {
  const auto& [velocity, acceleration] = seen_.front();
  return {after(displacement_, 0.5 * dt_, velocity), velocity, acceleration};
}

std::vector<Pass> RigidBase::passes(Ground& ground) {
  const auto halt = [this, &ground](Step&) { stop(ground); };
  std::vector<Pass> passes{
      {Phase::scatter, "", halt},
      {Phase::forces, "inertia",
       [this, &ground](Step& step) {
         for (int clock = step.ticks.first_due(); clock < step.ticks.clocks(); ++clock)
           push(ground, step.ticks, clock, step.nodes.of(clock));
       }},
      {Phase::books, "", [this, &ground](Step& step) {
         for (int clock = step.ticks.first_due(); clock < step.ticks.clocks(); ++clock)
           step.bookings.add(power(ground, clock, step.nodes.of(clock)),
                             [&energy = step.energy, kick = step.ticks.kick_of(clock)](const auto& total) {
                               energy.input += kick * total[0];
                             });
       }}};
  if (ground.has_flow())
    passes.push_back(
        {Phase::books, "", [this, &ground](Step& step) { release_water(ground, 0, step.nodes.of(0)); }});
  if (ground.is_remapped()) {
    passes.push_back({Phase::gather, "", halt});
    passes.push_back({Phase::remap, "", [this, &ground](Step& step) {
                        for (int clock = step.ticks.first_ending(); clock < step.ticks.clocks(); ++clock)
                          step.remap_power[static_cast<std::size_t>(clock)][0] +=
                              remap_power(ground, clock, step.nodes.of(clock))[0];
                      }});
  }
  return passes;
}

void RigidBase::add_state(SavedNumbers& state) {
  state.add(velocity_, rate_, displacement_, dt_);
  for (Seen& seen : seen_)
    state.add(seen.velocity, seen.acceleration);
}

} // namespace tremolo::mpm_domain
