#include "mpm_domain/boundary/face_forces.hpp"

#include "mpm_domain/boundary/for_faces.hpp"
#include "mpm_domain/ground.hpp"

#include <algorithm>
#include <array>

namespace tremolo::mpm_domain {

namespace {

/// A clock for each level of cells.
constexpr std::size_t most_clocks = mesh::finest_level_allowed + 1;

/// Impulses of a clock given to a node of a faster one within one of its steps: the factor on the force.
double impulse_factor(int node_clock, int clock) {
  return static_cast<double>(1 << (node_clock - clock));
}

/// Adds the work of a face in an update.
/// @param v_of   of its nodes by clock, mean over the update, m/s
/// @param kicks  time that the forces of a clock have acted for, s
void add_work_of_face(std::size_t f, const FaceLoads& loads, const Ticks& ticks, std::span<const Vector> v_of,
                      std::span<const double> kicks, BoundaryWork& work) {
  const BoundaryFace& face = loads.faces[f];
  const auto& [viscous, dynamic, held] = loads.eq6[f];
  const int of_face = loads.motion.clock(f);
  const double steady = ticks.steady_share(of_face) * face.length;
  Vector v_all;    // of all nodes that are due
  Vector v_moving; // of those that the moving part acts on
  for (int clock = ticks.first_due(); clock < ticks.clocks(); ++clock) {
    const Vector& v = v_of[static_cast<std::size_t>(clock)];
    v_all += v;
    if (clock >= of_face)
      v_moving += v;
    work.held += kicks[static_cast<std::size_t>(clock)] * steady * dot(held, v);
  }
  if (loads.motion.is_due(ticks, f)) {
    const double impulse = kicks[static_cast<std::size_t>(of_face)] * face.length;
    const double own = dot(eq6::viscous_traction(face.dashpots(), loads.motion.velocity(f)), v_moving);
    work.dashpots += impulse * own;
    work.input += impulse * (dot(viscous + dynamic, v_moving) - own);
    if (!loads.supports.empty()) {
      // Springs keep what the free field gives to their far ends less what they give to the nodes.
      const SupportLoad& support = loads.supports[f];
      const double given = impulse * dot(support.spring, support.far_end);
      work.input += given;
      work.transfer -= given - impulse * dot(support.spring, v_moving);
    }
  }
  if (ticks.is_first() && !loads.supports.empty()) {
    const SupportLoad& support = loads.supports[f];
    work.dashpots += kicks[0] * face.length * dot(support.own, v_all);
    work.input += kicks[0] * face.length * dot(support.driven, v_all);
  }
}

} // namespace

void FaceForces::follow_sort(const Ground& ground) {
  const std::size_t nodes = ground.grid.size();
  if (nodes_.restart(nodes))
    for (NodeField* field : {&on_nodes_x_, &on_nodes_y_})
      set_to_zeros(*field, nodes);
  nodes_in_rows_ = not_found; // tiles may have changed hands
  dashpots_.resize(static_cast<std::size_t>(ground.clocks.count()), ConsistentDashpots(nodes_));
  for (ConsistentDashpots& dashpots : dashpots_)
    dashpots.fit(nodes);
}

void FaceForces::add(Step& step, const FaceLoads& loads) {
  Grid& grid = step.ground.grid;
  const Ticks& ticks = step.ticks;
  const std::span<const FaceWeights> weights = loads.motion.weights();
  nodes_.add(weights);
  nodes_.add(loads.lean.weights());
  find_rows(step.ground);
  const auto clocks = static_cast<std::size_t>(ticks.clocks());
  if (ticks.first_due() > 0)
    std::ranges::fill(loads_, Load{}); // for clocks that are not due
  loads_.resize(weights.size() * clocks);
  for (int clock = ticks.first_due(); clock < ticks.clocks(); ++clock)
    find(clock, ticks, loads);
  const bool one_clock = step.nodes.one_clock();
  const auto is_due = [&](std::size_t n) { return one_clock || step.nodes.clock_of(n) >= ticks.first_due(); };
  step.ground.workers.run(2, [&](std::size_t component) {
    const auto spread_along = [&](double Vector::*axis, NodeField& boundary, NodeField& force,
                                  NodeField& dashpot) {
      for (const std::size_t n : nodes_.all())
        if (is_due(n))
          boundary[n] = 0.0;
      for (const std::size_t f : loads.near.all()) {
        const Load* const of_face = &loads_[f * clocks];
        for (const auto& [node, w] : weights[f]) {
          const Load& load = of_face[one_clock ? 0 : step.nodes.clock_of(node)];
          boundary[node] += w * load.force.*axis;
          dashpot[node] += w * load.dashpot.*axis;
        }
      }
      for (std::size_t e = 0; e < loads.lean.edges().size(); ++e)
        for (const auto& [node, w] : loads.lean.weights()[e])
          boundary[node] += w * loads.lean.edges()[e].on_soil.*axis;
      for (const std::size_t n : nodes_.all())
        if (is_due(n))
          force[n] += boundary[n];
    };
    if (component == 0)
      spread_along(&Vector::x, on_nodes_x_, grid.force_x, grid.dashpot_x);
    else
      spread_along(&Vector::y, on_nodes_y_, grid.force_y, grid.dashpot_y);
  });
  correct_dashpots(step, loads);
}

/// Computes the loads of all faces on their nodes of a clock that is due at this tick.
void FaceForces::find(int clock, const Ticks& ticks, const FaceLoads& loads) {
  const auto clocks = static_cast<std::size_t>(ticks.clocks());
  const double reacts = ticks.is_first() ? impulse_factor(clock, 0) : 0.0;
  // A mass m_L that moves with the node adds m_L to m in (m + dt C/2) (v+ - v-) = dt f: it is a dashpot C = 2
  // m_L/dt that is not in f.
  const double per_kick = 2.0 / ticks.kick_of(clock);
  std::array<double, most_clocks> steady{};
  for (int of_face = 0; of_face < ticks.clocks(); ++of_face)
    steady[static_cast<std::size_t>(of_face)] = ticks.steady_share(of_face);
  for (const std::size_t f : loads.near.all()) {
    const BoundaryFace& face = loads.faces[f];
    const int of_face = loads.motion.clock(f);
    // A node of a slower clock that the face has reached since the first tick waits for the next one.
    const double moves =
        loads.motion.is_due(ticks, f) && clock >= of_face ? impulse_factor(clock, of_face) : 0.0;
    const double holds = steady[static_cast<std::size_t>(of_face)];
    const Vector z = dashpot_diagonal(face);
    const Vector inertia = per_kick * face.behind.moving_mass;
    const double l = face.length;
    const auto& [viscous, dynamic, held] = loads.eq6[f];
    Vector moving = viscous + dynamic;
    Vector reaction;
    if (!loads.supports.empty()) {
      const SupportLoad& support = loads.supports[f];
      moving += support.spring;
      reaction = support.reaction();
    }
    loads_[f * clocks + static_cast<std::size_t>(clock)] = {
        {l * (moves * moving.x + reacts * reaction.x + holds * held.x),
         l * (moves * moving.y + reacts * reaction.y + holds * held.y)},
        l * (moves * z + inertia)};
  }
}

/// Faces whose nodes are all of one clock have consistent dashpots; the few others stay lumped.
void FaceForces::correct_dashpots(Step& step, const FaceLoads& loads) {
  const Ticks& ticks = step.ticks;
  const std::span<const FaceWeights> all = loads.motion.weights();
  if (ticks.clocks() == 1)
    return dashpots_.front().correct(step.ground, loads.faces, loads.near.all(), all, ticks.kick_of(0));
  consistent_.resize(dashpots_.size());
  for (int clock = ticks.first_due(); clock < ticks.clocks(); ++clock) {
    std::vector<FaceWeights>& weights = consistent_[static_cast<std::size_t>(clock)];
    weights.assign(all.size(), {});
    for (std::size_t f = 0; f < all.size(); ++f)
      if (std::ranges::all_of(all[f],
                              [&](const FaceWeight& w) { return step.nodes.clock_of(w.node) == clock; }))
        weights[f] = all[f];
    dashpots_[static_cast<std::size_t>(clock)].correct(step.ground, loads.faces, loads.near.all(), weights,
                                                       ticks.kick_of(clock));
  }
}

ExactSums<BoundaryWork::count> FaceForces::work(Step& step, const FaceLoads& loads) const {
  Ground& ground = step.ground;
  const Grid& grid = ground.grid;
  const Ticks& ticks = step.ticks;
  const bool one_clock = step.nodes.one_clock();
  const std::span<const FaceWeights> weights = loads.motion.weights();
  std::array<double, most_clocks> kicks{};
  for (int clock = 0; clock < ticks.clocks(); ++clock)
    kicks[static_cast<std::size_t>(clock)] = ticks.kick_of(clock);
  std::vector<std::array<double, BoundaryWork::count>> works(loads.near.group_count());
  ground.workers.run(works.size(), [&](std::size_t group) {
    std::array<Vector, most_clocks> v_of;
    BoundaryWork work;
    for (const std::size_t f : loads.near.group(group)) {
      std::fill_n(v_of.begin(), ticks.clocks(), Vector{});
      for (const auto& [node, w] : weights[f]) {
        Vector& v = v_of[one_clock ? 0 : static_cast<std::size_t>(step.nodes.clock_of(node))];
        const double half = 0.5 * w;
        v.x += half * (grid.vx_before[node] + grid.vx_after[node]);
        v.y += half * (grid.vy_before[node] + grid.vy_after[node]);
      }
      add_work_of_face(f, loads, ticks, v_of, kicks, work);
    }
    works[group] = work.numbers();
  });
  ExactSums<BoundaryWork::count> sums =
      sums_of(std::span<const std::array<double, BoundaryWork::count>>(works));
  for (int clock = ticks.first_due(); clock < static_cast<int>(dashpots_.size()); ++clock) {
    const double half_kick = 0.5 * ticks.kick_of(clock);
    const ConsistentDashpots& dashpots = dashpots_[static_cast<std::size_t>(clock)];
    sums[BoundaryWork::of_dashpots] += sum_over_nodes(ground, [&](std::size_t n) {
      return half_kick * dot(dashpots.force_on(n),
                             {grid.vx_before[n] + grid.vx_after[n], grid.vy_before[n] + grid.vy_after[n]});
    });
  }
  return sums;
}

void FaceForces::take_off_remap_power(Step& step, int clock) const {
  Ground& ground = step.ground;
  const Grid& grid = ground.grid;
  const auto of_clock = static_cast<std::size_t>(clock);
  const ConsistentDashpots* const dashpots = of_clock < dashpots_.size() ? &dashpots_[of_clock] : nullptr;
  step.remap_power[of_clock][0] += sum_over_nodes(ground, [&](std::size_t n) {
    if (step.nodes.clock_of(n) != clock)
      return 0.0;
    const Vector corrected = dashpots ? dashpots->force_on(n) : Vector{};
    return (on_nodes_x_[n] + corrected.x) * (grid.vx_strain[n] - grid.vx_after[n]) +
           (on_nodes_y_[n] + corrected.y) * (grid.vy_strain[n] - grid.vy_after[n]);
  });
}

/// Pieces of the rows of nodes, each in one tile, so that their sums are the same for any number of ranks.
void FaceForces::find_rows(const Ground& ground) {
  const std::span<const std::size_t> all = nodes_.all();
  if (nodes_in_rows_ == all.size())
    return;
  nodes_in_rows_ = all.size();
  rows_.clear();
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    const NodePosition at = ground.position_of(all[begin]);
    const std::size_t tile = ground.tiles.tile_of(at.level, at.column, at.row);
    const Lattice& lattice = ground.lattice(at.level);
    const std::size_t last =
        lattice.index(std::min(ground.tiles.owned(tile).end_column(), lattice.nx) - 1, at.row);
    while (end < all.size() && all[end] <= last)
      ++end;
    if (!ground.share || ground.share->is_mine(tile))
      rows_.push_back(all.subspan(begin, end - begin));
  }
}

/// @param of_node  (node) its part of the sum
template <typename OfNode>
ExactSum FaceForces::sum_over_nodes(Ground& ground, const OfNode& of_node) const {
  std::vector<std::array<double, 1>> parts(rows_.size());
  constexpr std::size_t rows_per_task = 64;
  ground.workers.run((rows_.size() + rows_per_task - 1) / rows_per_task, [&](std::size_t task) {
    for (std::size_t r = task * rows_per_task; r < std::min((task + 1) * rows_per_task, rows_.size()); ++r)
      for (const std::size_t n : rows_[r])
        parts[r][0] += of_node(n);
  });
  return sums_of(std::span<const std::array<double, 1>>(parts))[0];
}

} // namespace tremolo::mpm_domain
