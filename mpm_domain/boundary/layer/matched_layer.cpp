#include "mpm_domain/boundary/layer/matched_layer.hpp"

#include "mpm_domain/ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// Start and end of a face along its side, m.
struct Reach {
  double from;
  double to;
};

Reach reach(const BoundaryFace& face) {
  const double middle = face.side == Side::base ? face.position.x : face.position.y;
  return {middle - 0.5 * face.length, middle + 0.5 * face.length};
}

bool is_matched(const Ground& ground, Side side) {
  return std::ranges::find(ground.spec.matched_sides, side) != ground.spec.matched_sides.end();
}

std::span<const BoundaryFace> faces_of(std::span<const BoundaryFace> all, Side side) {
  const auto first = std::ranges::lower_bound(all, side, {}, &BoundaryFace::side);
  const auto last = std::ranges::upper_bound(all, side, {}, &BoundaryFace::side);
  if (first == last)
    throw std::invalid_argument(fmt::format("the {} has no faces for a matched layer", text_of(side)));
  for (auto face = first + 1; face != last; ++face)
    if (std::abs(reach(*face).from - reach(*(face - 1)).to) > 1e-6 * face->length)
      throw std::invalid_argument(
          fmt::format("a matched layer behind the {} needs soil all along it; there is none between {:.6g} "
                      "and {:.6g} m",
                      text_of(side), reach(*(face - 1)).to, reach(*face).from));
  return {first, last};
}

/// Density of the ground that the face's impedances belong to, kg/m3.
double ground_density(const Ground& ground, const BoundaryFace& face) {
  if (face.side == Side::base && ground.spec.below_base)
    return ground.spec.below_base->density;
  return materials::elasticity(ground.sets[face.set].law).density;
}

/// Elastic constants per area of the boundary between two positions, in the soil's present stress.
LayerColumn column_between(const Ground& ground, std::span<const BoundaryFace> faces, Reach span) {
  LayerColumn column{.width = span.to - span.from};
  for (const BoundaryFace& face : faces) {
    const double share =
        (std::min(span.to, reach(face).to) - std::max(span.from, reach(face).from)) / column.width;
    if (!(share > 1e-9))
      continue;
    const double density = ground_density(ground, face);
    column.density += share * density;
    column.p_modulus += share * face.ground.impedance_p * face.ground.impedance_p / density;
    column.shear_modulus += share * face.ground.impedance_s * face.ground.impedance_s / density;
  }
  return column;
}

/// The fastest P wave of the ground behind any layer, m/s: they all stretch alike.
double fastest(const Ground& ground, std::span<const BoundaryFace> all) {
  double speed = 0.0;
  for (const BoundaryFace& face : all)
    if (is_matched(ground, face.side))
      speed = std::max(speed, face.ground.impedance_p / ground_density(ground, face));
  return speed;
}

LayerShape shape(const Ground& ground, std::span<const BoundaryFace> all, Side side) {
  const std::span<const BoundaryFace> faces = faces_of(all, side);
  const Spec& spec = ground.spec;
  const Reach whole = {reach(faces.front()).from, reach(faces.back()).to};
  const double length = whole.to - whole.from;
  const int count = std::max(1, static_cast<int>(std::lround(length / spec.cell_size)));
  LayerShape result;
  for (int i = 0; i < count; ++i)
    result.columns.push_back(column_between(
        ground, faces, {whole.from + length * i / count, whole.from + length * (i + 1) / count}));
  result.cells = spec.layer_cells;
  result.depth = spec.layer_cells * spec.cell_size;
  result.fastest = fastest(ground, all);
  const auto towards = [&](Side other) {
    return is_matched(ground, other) ? LayerEnd::corner : LayerEnd::dashpots;
  };
  if (spec.periodic())
    result.ends = {LayerEnd::repeated, LayerEnd::repeated};
  else if (side == Side::base)
    result.ends = {towards(Side::left), towards(Side::right)};
  else
    result.ends = {towards(Side::base), LayerEnd::free}; // at the ground's surface
  return result;
}

/// Integral of the hat of node 0 of a lattice of unit cells from -1 to x.
double hat_integral(double x) {
  const double u = std::clamp(x, -1.0, 1.0);
  return 0.5 + u - 0.5 * u * std::abs(u);
}

} // namespace

MatchedLayer::MatchedLayer(const Ground& ground, std::span<const BoundaryFace> all, Side side)
    : side_(side), lattice_(shape(ground, all, side)) {
  const std::span<const BoundaryFace> faces = faces_of(all, side);
  first_ = static_cast<std::size_t>(&faces.front() - all.data());
  normal_ = faces.front().ground.normal;
  along_ = {std::abs(normal_.y), std::abs(normal_.x)};
  const double from = reach(faces.front()).from;
  const double length = reach(faces.back()).to - from;
  const std::size_t nodes = lattice_.width();
  const std::size_t cells = nodes - (ground.spec.periodic() ? 0 : 1);
  const double width = length / static_cast<double>(cells);

  std::vector<double> covered(nodes);
  for (const BoundaryFace& face : faces) {
    const double a = (reach(face).from - from) / width;
    const double b = (reach(face).to - from) / width;
    Tie& tie = ties_.emplace_back();
    tie.length = face.length;
    for (std::size_t i = 0; i <= cells; ++i) {
      const double at = static_cast<double>(i);
      const double part = hat_integral(b - at) - hat_integral(a - at);
      if (part > 1e-9) {
        tie.weights.emplace_back(i % nodes, part);
        covered[i % nodes] += part;
      }
    }
  }
  for (Tie& tie : ties_)
    for (auto& [j, weight] : tie.weights)
      weight /= covered[j];
  v_free_.resize(faces.size());
  a_free_.resize(faces.size());
  velocity_.resize(nodes);
}

Vector MatchedLayer::local(Vector v) const {
  return {dot(v, along_), dot(v, normal_)};
}

void MatchedLayer::lump(std::span<BoundaryFace> all) {
  for (std::size_t f = 0; f < ties_.size(); ++f) {
    Tie& tie = ties_[f];
    for (const auto& [j, weight] : tie.weights)
      tie.mass += weight * lattice_.boundary_mass()[j] / tie.length;
    all[first_ + f].behind = {.has_dashpots = false, .moving_mass = {tie.mass, tie.mass}};
  }
}

void MatchedLayer::follow(std::span<const Vector> v_domain, std::span<const eq6::FreeField> free_field) {
  std::ranges::fill(velocity_, Vector{});
  for (std::size_t f = 0; started_ && f < ties_.size(); ++f) {
    const Vector now = free_field[first_ + f].velocity;
    const Vector v = v_domain[first_ + f];
    const Vector w = local(v - 0.5 * (v_free_[f] + now));
    for (const auto& [j, weight] : ties_[f].weights) {
      velocity_[j] += weight * w;
    }
  }
}

void MatchedLayer::advance(double time, WorkerPool& workers) {
  if (started_)
    lattice_.advance(time - time_, velocity_, workers);
}

void MatchedLayer::react(double time, std::span<const eq6::FreeField> free_field,
                         std::span<SupportLoad> loads) {
  const double dt = time - time_;
  for (std::size_t f = 0; f < ties_.size(); ++f) {
    const Vector now = free_field[first_ + f].velocity;
    Vector force;
    for (const auto& [j, weight] : ties_[f].weights) {
      force += weight * lattice_.boundary_force(j);
    }
    // The free field's acceleration, carried on by half a step.
    const Vector a = started_ ? (now - v_free_[f]) / dt : Vector{};
    const double mass = ties_[f].mass;
    Vector& traction = loads[first_ + f].own = {};
    traction.x += (force.x * along_.x + force.y * normal_.x) / ties_[f].length +
                  mass * (1.5 * a.x - 0.5 * a_free_[f].x);
    traction.y += (force.x * along_.y + force.y * normal_.y) / ties_[f].length +
                  mass * (1.5 * a.y - 0.5 * a_free_[f].y);
    a_free_[f] = a;
    v_free_[f] = now;
  }
  time_ = time;
  started_ = true;
}

void MatchedLayer::add_state(SavedNumbers& state) {
  lattice_.add_state(state);
  state.add(started_, time_, v_free_, a_free_);
}

MatchedLayers::MatchedLayers(const Ground& ground, std::span<BoundaryFace> faces) {
  for (const Side side : ground.spec.matched_sides)
    layers_.emplace_back(ground, faces, side);
  for (std::size_t s = 0; s < layers_.size(); ++s)
    for (std::size_t b = 0; b < layers_.size(); ++b)
      if (layers_[s].side() != Side::base && layers_[b].side() == Side::base)
        corners_.push_back({s, b, LayerJoint(layers_[s].side(), layers_[s].lattice(), layers_[b].lattice())});
  for (MatchedLayer& layer : layers_)
    layer.lump(faces);
}

void MatchedLayers::exchange(const Exchange& at, std::span<SupportLoad> loads) {
  for (MatchedLayer& layer : layers_)
    layer.follow(at.seen_mean, at.field);
  at.workers.run(corners_.size(), [&](std::size_t c) { // each leads an end of its own of the base's layer
    auto& [s, b, joint] = corners_[c];
    if (const std::optional<double> dt = layers_[b].step_to(at.time))
      joint.advance(*dt, layers_[s].end_velocity(0), layers_[b].end_velocity(joint.base_end()),
                    layers_[s].lattice(), layers_[b].lattice());
  });
  for (MatchedLayer& layer : layers_)
    layer.advance(at.time, at.workers);
  for (const auto& [s, b, joint] : corners_)
    joint.pull(layers_[s].lattice(), layers_[b].lattice());
  for (MatchedLayer& layer : layers_)
    layer.react(at.time, at.field, loads);
}

void MatchedLayers::add_state(SavedNumbers& state) {
  for (MatchedLayer& layer : layers_)
    layer.add_state(state);
  for (Corner& corner : corners_)
    corner.joint.add_state(state);
}

} // namespace tremolo::mpm_domain
