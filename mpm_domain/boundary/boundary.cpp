#include "mpm_domain/boundary/boundary.hpp"

#include "mpm_domain/clocks/clock_nodes.hpp"
#include "mpm_domain/clocks/ticks.hpp"
#include "mpm_domain/ground.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// A clock for each level of cells.
constexpr std::size_t most_clocks = mesh::finest_level_allowed + 1;

/// A node with less of a face is not touched by it: rounding of weights.
constexpr double negligible = 1e-12;

constexpr std::size_t faces_per_task = 64;

/// act(f) for all faces, portions of them side by side.
template <typename Act>
void for_faces(WorkerPool& workers, std::size_t count, const Act& act) {
  workers.run((count + faces_per_task - 1) / faces_per_task, [&](std::size_t task) {
    for (std::size_t f = task * faces_per_task; f < std::min((task + 1) * faces_per_task, count); ++f)
      act(f);
  });
}

/// v_f = sum_i W_if v_i, m/s.
template <typename OfNode>
Vector sum_over(const FaceWeights& weights, const OfNode& of_node) {
  Vector sum;
  for (const auto& [node, w] : weights) {
    const Vector v = of_node(node);
    sum.x += w * v.x;
    sum.y += w * v.y;
  }
  return sum;
}

/// Where water flows, dashpots see grains and water together, which the implicit half of the dashpots acts on
/// too (water/mixture_kick.hpp): a dashpot that saw the grains alone could bring in energy.
Vector velocity_at(const Grid& grid, const FaceWeights& weights) {
  return sum_over(weights, [&](std::size_t node) { return grid.mixture_before(node); });
}

Vector velocity_after_at(const Grid& grid, const FaceWeights& weights) {
  return sum_over(weights, [&](std::size_t node) { return grid.mixture_after(node); });
}

/// Impulses of a clock given to a node of a faster one within one of its steps: the factor on the force.
double impulse_factor(int node_clock, int clock) {
  return static_cast<double>(1 << (node_clock - clock));
}

} // namespace

void Boundary::match(std::vector<Particles>& sets, const Spec& spec) {
  faces_ = find_faces(sets, spec);
  if (spec.rigid_base && !rigid_base_)
    rigid_base_.emplace();
  resize();
}

void Boundary::remove_faces() {
  faces_.clear();
  layers_.clear();
  corners_.clear();
  springs_.reset();
  ground_springs_.reset();
  rigid_base_.reset();
  resize();
}

void Boundary::resize() {
  const std::size_t count = faces_.size();
  weights_.assign(count, {});
  clock_.assign(count, 0);
  free_field_.assign(count, {});
  for (std::vector<Vector>* field : {&v_exchange_, &v_, &reaction_, &spring_})
    field->assign(count, {});
  traction_.assign(count, {});
  step_sums_.assign(3 * count, 0.0);
  v_kicked_.clear();
}

void Boundary::build_supports(const Ground& ground) {
  if (supported_)
    return;
  supported_ = true;
  for (const Side side : ground.spec.matched_sides)
    layers_.emplace_back(ground, faces_, side);
  corners_ = join(layers_);
  for (const MatchedLayer& layer : layers_) {
    for (std::size_t f = 0; f < layer.face_count(); ++f) {
      BoundaryFace& face = faces_[layer.first_face() + f];
      face.support = Support::matched_layer;
      face.moving_mass = {layer.mass(f), layer.mass(f)};
    }
  }
  if (ground.is_sharp() && !faces_.empty()) {
    closing_.emplace(ground, faces_);
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (faces_[f].support == Support::dashpots) {
        faces_[f].support = Support::closing_element;
        faces_[f].moving_mass = closing_->mass(f);
      }
  }
  if (ground.spec.sides == Sides::periodic_springs && !faces_.empty()) {
    springs_.emplace(ground, faces_);
    for (std::size_t f = 0; f < springs_->face_count(); ++f)
      faces_[f].support = Support::opposite_face;
  }
  if (GroundSprings springs(faces_, ground.spec); springs.any()) {
    free_field_.resize(faces_.size() + springs.more_fields());
    ground_springs_.emplace(std::move(springs));
  }
}

void Boundary::follow_sort(const Ground& ground) {
  if (rigid_base_)
    rigid_base_->follow_sort(ground);
  const std::size_t nodes = ground.grid.size();
  if (nodes_.restart(nodes))
    for (NodeField* field : {&on_nodes_x_, &on_nodes_y_})
      field->assign(nodes, 0.0);
  dashpots_.resize(static_cast<std::size_t>(ground.clocks.count()), ConsistentDashpots(nodes_));
  for (ConsistentDashpots& dashpots : dashpots_)
    dashpots.fit(nodes);
  if (ground.mesh)
    for (BoundaryFace& face : faces_)
      face.level = level_of(ground, face);
  if (ground.share && !faces_.empty())
    share_.emplace(ground, faces_);
}

void Boundary::read_soil(Ground& ground) {
  if (!share_ && !ground.has_pore_pressure())
    return; // places are all that dry soil needs of its faces
  soil_.resize(faces_.size());
  if (share_)
    share_->tell(ground, faces_, soil_);
  else
    for_faces(ground.workers, faces_.size(),
              [&](std::size_t f) { soil_[f] = soil_at(faces_[f], ground.sets[faces_[f].set]); });
  if (ground.has_pore_pressure())
    for (std::size_t f = 0; f < faces_.size(); ++f)
      faces_[f].length = soil_[f].length;
}

bool Boundary::is_due(int first_due, std::size_t f) const {
  return clock_[f] >= first_due;
}

/// The face's weights at the place of its soil, and at the first tick its clock.
void Boundary::weigh(const Ground& ground, const ClockNodes& nodes, std::size_t f, bool first_tick) {
  if (soil_.empty())
    face_weights(ground, faces_[f], weights_[f]);
  else
    face_weights(ground, faces_[f], soil_[f].place, weights_[f]);
  if (ground.clocks.count() == 1)
    return;
  std::erase_if(weights_[f],
                [&](const FaceWeight& w) { return w.w < negligible || nodes.clock_of(w.node) < 0; });
  if (!first_tick)
    return;
  clock_[f] = ground.clocks.count() - 1;
  for (const FaceWeight& w : weights_[f])
    clock_[f] = std::min(clock_[f], nodes.clock_of(w.node));
}

void Boundary::exchange(Ground& ground, const ClockNodes& nodes, const FreeFieldSource& source, long step,
                        double time) {
  for_faces(ground.workers, faces_.size(), [&](std::size_t f) {
    weigh(ground, nodes, f, true);
    const Vector v = velocity_at(ground.grid, weights_[f]);
    v_exchange_[f] = v_kicked_.empty() ? v : without_residual(v, v_kicked_[f]);
    if (ground_springs_ && ground_springs_->holds(f))
      add_to_step_mean(f, v);
  });
  v_ = v_exchange_;
  source(step, time, v_exchange_, free_field_);
  if (springs_)
    springs_->pull(ground, faces_, v_exchange_, reaction_, free_field_);
  if (closing_)
    close(time);
  if (ground_springs_)
    move_springs(time);
  for (std::size_t f = 0; f < faces_.size(); ++f)
    evaluate(f);
  if (ground.has_pore_pressure())
    lean_.find(ground, faces_, soil_, free_field_);
}

/// Reactions of the elements behind the faces.
void Boundary::close(double time) {
  closing_->advance(time, v_exchange_, free_field_);
  for (std::size_t f = 0; f < faces_.size(); ++f)
    if (faces_[f].support == Support::closing_element) {
      const Vector soil = closing_->of_soil(f);
      const Vector field = closing_->of_free_field(f);
      reaction_[f] = {soil.x + field.x, soil.y + field.y};
    }
}

void Boundary::move_springs(double time) {
  std::vector<Vector> mean(faces_.size());
  for (std::size_t f = 0; f < faces_.size(); ++f)
    if (ground_springs_->holds(f))
      mean[f] = take_step_mean(f);
  springs_took_ = ground_springs_->move(time, mean, free_field_);
  for (std::size_t f = 0; f < faces_.size(); ++f)
    spring_[f] = ground_springs_->traction(f);
}

/// Adds a velocity (m/s) of the face at a tick to the mean over a step of clock 0.
void Boundary::add_to_step_mean(std::size_t f, Vector v) {
  const double weight = 1.0 / static_cast<double>(1 << clock_[f]);
  step_sums_[3 * f] += weight * v.x;
  step_sums_[3 * f + 1] += weight * v.y;
  step_sums_[3 * f + 2] += weight;
}

/// The mean, m/s; the next one begins.
Vector Boundary::take_step_mean(std::size_t f) {
  double* const sums = &step_sums_[3 * f];
  const Vector mean{sums[0] / sums[2], sums[1] / sums[2]};
  std::fill_n(sums, 3, 0.0);
  return mean;
}

void Boundary::react(double time, WorkerPool& workers) {
  std::vector<Vector> mean(faces_.size());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (faces_[f].support != Support::matched_layer)
      continue;
    add_to_step_mean(f, v_[f]);
    mean[f] = take_step_mean(f);
    reaction_[f] = {};
  }
  mpm_domain::react(layers_, corners_, time, mean, free_field_, reaction_, workers);
}

void Boundary::evaluate(std::size_t f) {
  traction_[f] = eq6::boundary_traction(faces_[f].dashpots(), v_[f], free_field_[f], faces_[f].held);
}

void Boundary::apply(Ground& ground, const Ticks& ticks, const ClockNodes& nodes) {
  const int first_due = ticks.first_due();
  if (faces_.empty())
    return;
  if (!ticks.is_first())
    for_faces(ground.workers, faces_.size(), [&](std::size_t f) {
      if (!is_due(first_due, f))
        return;
      weigh(ground, nodes, f, false);
      v_[f] = velocity_at(ground.grid, weights_[f]);
      evaluate(f);
      if (faces_[f].support == Support::matched_layer || (ground_springs_ && ground_springs_->holds(f)))
        add_to_step_mean(f, v_[f]);
    });
  spread(ground, ticks, nodes);
  correct_dashpots(ground, ticks, nodes);
}

void Boundary::spread(Ground& ground, const Ticks& ticks, const ClockNodes& nodes) {
  Grid& grid = ground.grid;
  nodes_.add(weights_);
  nodes_.add(lean_.weights());
  const auto clocks = static_cast<std::size_t>(ticks.clocks());
  if (ticks.first_due() > 0)
    std::ranges::fill(loads_, Load{}); // for clocks that are not due
  loads_.resize(faces_.size() * clocks);
  for (int clock = ticks.first_due(); clock < ticks.clocks(); ++clock)
    find_loads(clock, ticks);
  const bool one_clock = nodes.one_clock();
  const auto is_due = [&](std::size_t n) { return one_clock || nodes.clock_of(n) >= ticks.first_due(); };
  ground.workers.run(2, [&](std::size_t component) {
    const auto spread_along = [&](double Vector::*axis, NodeField& boundary, NodeField& force,
                                  NodeField& dashpot) {
      for (const std::size_t n : nodes_.all())
        if (is_due(n))
          boundary[n] = 0.0;
      for (std::size_t f = 0; f < faces_.size(); ++f) {
        const Load* const loads = &loads_[f * clocks];
        for (const auto& [node, w] : weights_[f]) {
          const Load& load = loads[one_clock ? 0 : nodes.clock_of(node)];
          boundary[node] += w * load.force.*axis;
          dashpot[node] += w * load.dashpot.*axis;
        }
      }
      for (std::size_t e = 0; e < lean_.edges().size(); ++e)
        for (const auto& [node, w] : lean_.weights()[e])
          boundary[node] += w * lean_.edges()[e].on_soil.*axis;
      for (const std::size_t n : nodes_.all())
        if (is_due(n))
          force[n] += boundary[n];
    };
    if (component == 0)
      spread_along(&Vector::x, on_nodes_x_, grid.force_x, grid.dashpot_x);
    else
      spread_along(&Vector::y, on_nodes_y_, grid.force_y, grid.dashpot_y);
  });
}

/// Computes the loads of all faces on their nodes of a clock that is due at this tick.
void Boundary::find_loads(int clock, const Ticks& ticks) {
  const int first_due = ticks.first_due();
  const auto clocks = static_cast<std::size_t>(ticks.clocks());
  const double reacts = ticks.is_first() ? impulse_factor(clock, 0) : 0.0;
  // A mass m_L that moves with the node adds m_L to m in (m + dt C/2) (v+ - v-) = dt f: it is a dashpot C = 2
  // m_L/dt that is not in f.
  const double per_kick = 2.0 / ticks.kick_of(clock);
  std::array<double, most_clocks> steady{};
  for (int of_face = 0; of_face < ticks.clocks(); ++of_face)
    steady[static_cast<std::size_t>(of_face)] = ticks.steady_share(of_face);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const BoundaryFace& face = faces_[f];
    const auto& [viscous, dynamic, held] = traction_[f];
    // A node of a slower clock that the face has come to touch since the first tick waits for the next one.
    const double moves = is_due(first_due, f) && clock >= clock_[f] ? impulse_factor(clock, clock_[f]) : 0.0;
    const double holds = steady[static_cast<std::size_t>(clock_[f])];
    const Vector z = dashpot_diagonal(face);
    const Vector inertia{per_kick * face.moving_mass.x, per_kick * face.moving_mass.y};
    const double l = face.length;
    Load& load = loads_[f * clocks + static_cast<std::size_t>(clock)];
    Vector moving{viscous.x + dynamic.x, viscous.y + dynamic.y};
    if (ground_springs_)
      moving = {moving.x + spring_[f].x, moving.y + spring_[f].y};
    load.force = {l * (moves * moving.x + reacts * reaction_[f].x + holds * held.x),
                  l * (moves * moving.y + reacts * reaction_[f].y + holds * held.y)};
    load.dashpot = {l * (moves * z.x + inertia.x), l * (moves * z.y + inertia.y)};
  }
}

/// Faces whose nodes are all of one clock have consistent dashpots; the few others stay lumped.
void Boundary::correct_dashpots(Ground& ground, const Ticks& ticks, const ClockNodes& nodes) {
  if (ticks.clocks() == 1)
    return dashpots_.front().correct(ground, faces_, weights_, ticks.kick_of(0));
  consistent_.resize(dashpots_.size());
  for (int clock = ticks.first_due(); clock < ticks.clocks(); ++clock) {
    std::vector<FaceWeights>& weights = consistent_[static_cast<std::size_t>(clock)];
    weights.assign(faces_.size(), {});
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (std::ranges::all_of(weights_[f],
                              [&](const FaceWeight& w) { return nodes.clock_of(w.node) == clock; }))
        weights[f] = weights_[f];
    dashpots_[static_cast<std::size_t>(clock)].correct(ground, faces_, weights, ticks.kick_of(clock));
  }
}

BoundaryWork Boundary::follow_update(Ground& ground, const Ticks& ticks, const ClockNodes& nodes) {
  const int first_due = ticks.first_due();
  const Grid& grid = ground.grid;
  if (ground.has_pore_pressure()) {
    v_kicked_.resize(faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f)
      v_kicked_[f] = velocity_after_at(grid, weights_[f]);
  }
  std::vector<BoundaryWork> works((faces_.size() + faces_per_task - 1) / faces_per_task);
  ground.workers.run(works.size(), [&](std::size_t task) {
    const std::size_t first = task * faces_per_task;
    works[task] = work_of(first, std::min(first + faces_per_task, faces_.size()), grid, ticks, nodes);
  });
  BoundaryWork total;
  for (const BoundaryWork& work : works)
    total += work;
  total.input += ticks.kick_of(0) * lean_.power(grid);
  if (ground_springs_ && ticks.is_first()) {
    total.springs = springs_took_;
    total.transfer += springs_took_;
  }
  for (int clock = first_due; clock < static_cast<int>(dashpots_.size()); ++clock) {
    const ConsistentDashpots& dashpots = dashpots_[static_cast<std::size_t>(clock)];
    total.dashpots +=
        0.5 * ticks.kick_of(clock) *
        (dashpots.power(grid.vx_before, grid.vy_before) + dashpots.power(grid.vx_after, grid.vy_after));
  }
  return total;
}

/// The springs keep what the free field gives to their far ends less what they give to the nodes.
void Boundary::book_springs(std::size_t f, double impulse, Vector v, BoundaryWork& work) const {
  const double given = impulse * dot(spring_[f], ground_springs_->field_velocity(f));
  work.input += given;
  work.transfer -= given - impulse * dot(spring_[f], v);
}

BoundaryWork Boundary::work_of(std::size_t begin, std::size_t end, const Grid& grid, const Ticks& ticks,
                               const ClockNodes& nodes) const {
  const int first_due = ticks.first_due();
  const bool one_clock = nodes.one_clock();
  std::array<Vector, most_clocks> v_of; // of the face's nodes by clock, mean over the update, m/s
  std::array<double, most_clocks> kick{};
  for (int clock = 0; clock < ticks.clocks(); ++clock)
    kick[static_cast<std::size_t>(clock)] = ticks.kick_of(clock);
  BoundaryWork work;
  for (std::size_t f = begin; f < end; ++f) {
    const BoundaryFace& face = faces_[f];
    std::fill_n(v_of.begin(), ticks.clocks(), Vector{});
    for (const auto& [node, w] : weights_[f]) {
      Vector& v = v_of[one_clock ? 0 : static_cast<std::size_t>(nodes.clock_of(node))];
      const double half = 0.5 * w;
      v.x += half * (grid.vx_before[node] + grid.vx_after[node]);
      v.y += half * (grid.vy_before[node] + grid.vy_after[node]);
    }
    const double steady = ticks.steady_share(clock_[f]) * face.length;
    Vector v_all;    // of all nodes that are due
    Vector v_moving; // of those that the moving part acts on
    for (int clock = first_due; clock < ticks.clocks(); ++clock) {
      const Vector& v = v_of[static_cast<std::size_t>(clock)];
      v_all = {v_all.x + v.x, v_all.y + v.y};
      if (clock >= clock_[f])
        v_moving = {v_moving.x + v.x, v_moving.y + v.y};
      work.held += kick[static_cast<std::size_t>(clock)] * steady * dot(face.held, v);
    }
    if (is_due(first_due, f)) {
      const double impulse = kick[static_cast<std::size_t>(clock_[f])] * face.length;
      const double own = dot(eq6::viscous_traction(face.dashpots(), v_[f]), v_moving);
      work.dashpots += impulse * own;
      const auto& [viscous, dynamic, held] = traction_[f];
      work.input += impulse * (dot({viscous.x + dynamic.x, viscous.y + dynamic.y}, v_moving) - own);
      if (ground_springs_)
        book_springs(f, impulse, v_moving, work);
    }
    if (ticks.is_first() && face.support == Support::closing_element) {
      work.dashpots += kick[0] * face.length * dot(closing_->of_soil(f), v_all);
      work.input += kick[0] * face.length * dot(closing_->of_free_field(f), v_all);
    } else if (ticks.is_first() && face.support != Support::dashpots) {
      (face.support == Support::matched_layer ? work.dashpots : work.input) +=
          kick[0] * face.length * dot(reaction_[f], v_all);
    }
  }
  return work;
}

void Boundary::take_off_remap_power(Ground& ground, const ClockNodes& nodes, int clock,
                                    ExactSum& power) const {
  const Grid& grid = ground.grid;
  const auto of_clock = static_cast<std::size_t>(clock);
  const ConsistentDashpots* const dashpots = of_clock < dashpots_.size() ? &dashpots_[of_clock] : nullptr;
  const std::span<const std::size_t> all = nodes_.all();
  constexpr std::size_t nodes_per_task = 256;
  std::vector<ExactSum> parts((all.size() + nodes_per_task - 1) / nodes_per_task);
  ground.workers.run(parts.size(), [&](std::size_t task) {
    const std::size_t first = task * nodes_per_task;
    for (const std::size_t n : all.subspan(first, std::min(nodes_per_task, all.size() - first))) {
      if (nodes.clock_of(n) != clock || !ground.counts({n, n + 1}))
        continue;
      const Vector corrected = dashpots ? dashpots->force_on(n) : Vector{};
      parts[task].add((on_nodes_x_[n] + corrected.x) * (grid.vx_strain[n] - grid.vx_after[n]) +
                      (on_nodes_y_[n] + corrected.y) * (grid.vy_strain[n] - grid.vy_after[n]));
    }
  });
  for (const ExactSum& part : parts)
    power += part;
}

} // namespace tremolo::mpm_domain
