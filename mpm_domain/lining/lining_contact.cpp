#include "mpm_domain/lining/lining_contact.hpp"

#include "mpm_domain/lining/beam/beam_step.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

Vector difference(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y};
}

/// n of the even rows of a system, t of the odd ones.
Vector direction(std::span<const SegmentRows> rows, std::size_t row) {
  return row % 2 == 0 ? rows[row / 2].normal : rows[row / 2].tangent();
}

/// A node of a segment.
struct SegmentNode {
  std::size_t node;
  std::size_t row; ///< of the segment
  double share;
};

/// The nodes of all segments, node after node.
std::vector<SegmentNode> nodes_of(std::span<const SegmentRows> rows) {
  std::vector<SegmentNode> nodes;
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (const auto& [node, share] : rows[row].soil)
      nodes.push_back({node, row, share});
  std::ranges::sort(nodes, {}, [](const SegmentNode& of) { return std::pair(of.node, of.row); });
  return nodes;
}

/// The part of an entry of B m^-1 B^T that does not depend on directions.
struct Tensor {
  double xx = 0.0, yx = 0.0, xy = 0.0, yy = 0.0;

  double between(const Vector& a, const Vector& b) const {
    return a.x * (xx * b.x + xy * b.y) + a.y * (yx * b.x + yy * b.y);
  }
};

/// The lower half of B m^-1 B^T, row after row. Only segments that share nodes answer to each other.
std::vector<double> soil_answer(std::span<const SegmentRows> rows, const SoilMotion& soil) {
  const std::vector<SegmentNode> nodes = nodes_of(rows);
  const std::size_t count = rows.size();
  std::vector<Tensor> both(count * count);
  for (auto first = nodes.begin(); first != nodes.end();) {
    const auto end =
        std::find_if(first, nodes.end(), [&](const SegmentNode& of) { return of.node != first->node; });
    const Vector x = soil.of_grains(first->node, {1.0, 0.0});
    const Vector y = soil.of_grains(first->node, {0.0, 1.0});
    for (auto a = first; a != end; ++a)
      for (auto b = first; b <= a; ++b) {
        const double share = a->share * b->share;
        Tensor& to = both[a->row * count + b->row];
        to = {to.xx + share * x.x, to.yx + share * x.y, to.xy + share * y.x, to.yy + share * y.y};
      }
    first = end;
  }
  const std::size_t size = 2 * count;
  std::vector<double> g(size * size, 0.0);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = 0; b <= a; ++b)
      if (const Tensor& of_both = both[a * count + b]; of_both.xx != 0.0)
        for (const std::size_t r : {2 * a, 2 * a + 1})
          for (const std::size_t c : {2 * b, 2 * b + 1})
            g[r * size + c] = of_both.between(direction(rows, r), direction(rows, c));
  return g;
}

/// The lower half of H A^-1 H^T, row after row.
std::vector<double> beam_answer(std::span<const SegmentRows> rows, const BeamStep& step) {
  const std::size_t size = 2 * rows.size();
  std::vector<double> x(step.trial().size() * size, 0.0); // A^-1 H^T
  for (std::size_t c = 0; c < size; ++c)
    for (const auto& [dof, velocity] : rows[c / 2].beam)
      x[dof * size + c] = dot(velocity, direction(rows, c));
  step.answer(x, size);
  std::vector<double> g(size * size, 0.0);
  for (std::size_t r = 0; r < size; ++r)
    for (const auto& [dof, velocity] : rows[r / 2].beam) {
      const double share = dot(velocity, direction(rows, r));
      for (std::size_t c = 0; c <= r; ++c)
        g[r * size + c] += share * x[dof * size + c];
    }
  return g;
}

void mirror(std::vector<double>& g, std::size_t size) {
  for (std::size_t r = 0; r < size; ++r)
    for (std::size_t c = r + 1; c < size; ++c)
      g[r * size + c] = g[c * size + r];
}

/// B w - H v in the directions of all rows.
std::vector<double> closing_speeds(std::span<const SegmentRows> rows, const SoilMotion& soil,
                                   std::span<const double> v) {
  std::vector<double> closing;
  for (const SegmentRows& of : rows) {
    const Vector speed = difference(soil_velocity(of, soil.vx, soil.vy), beam_velocity(of, v));
    closing.push_back(dot(of.normal, speed));
    closing.push_back(dot(of.tangent(), speed));
  }
  return closing;
}

/// An impulse on the soil's side of a segment, node after node.
void add_impulse(const SegmentRows& rows, const Vector& impulse, std::vector<NodeChange>& to) {
  for (const auto& [node, share] : rows.soil) {
    auto found = std::ranges::lower_bound(to, node, {}, &NodeChange::node);
    if (found == to.end() || found->node != node)
      found = to.insert(found, {node, {}, {}});
    found->change = {found->change.x - share * impulse.x, found->change.y - share * impulse.y};
  }
}

/// From impulses to what they change.
void find_changes(const SoilMotion& soil, std::vector<NodeChange>& nodes) {
  for (auto& [node, change, water] : nodes) {
    const NodeFlow* flow = soil.flow(node);
    const Vector impulse = change;
    change = soil.of_grains(node, impulse);
    water = flow != nullptr ? flow->of_water(impulse) : change;
  }
}

} // namespace

LiningContact::LiningContact(const LiningSurface& surface)
    : segments_(surface.segments().size()), gaps_(segments_.size(), 0.0) {
  for (const SurfaceSegment& segment : surface.segments())
    lengths_.push_back(segment.length);
}

std::vector<double> LiningContact::meet(std::span<const SegmentRows> rows, const SoilMotion& soil,
                                        const BeamStep& step, double kick, double dt, bool bonded,
                                        const WaterBefore& water) {
  std::vector<double> closing = closing_speeds(rows, soil, step.trial());
  std::vector<SegmentContact> contacts;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    contacts.push_back(segments_[rows[k].segment]);
    const double time_on_area = lengths_[rows[k].segment] * kick;
    contacts.back().adhesion *= time_on_area;
    if (!water.nodes.empty())
      contacts.back().least_water = water.least[k] * time_on_area;
    if (!bonded)
      closing[2 * k] -= gaps_[rows[k].segment] / dt;
  }
  soil_answer_ = soil_answer(rows, soil);
  std::vector<double> of_beam = beam_answer(rows, step);
  std::vector<double> answer = soil_answer_;
  for (std::size_t i = 0; i < answer.size(); ++i)
    answer[i] += of_beam[i];
  mirror(answer, 2 * rows.size());
  SegmentWater borne;
  if (!water.nodes.empty()) {
    mirror(of_beam, 2 * rows.size());
    borne = find_segment_water(rows, water.nodes, of_beam, step.trial());
  }
  solve_segments(answer, closing, contacts, bonded, borne);

  std::vector<bool> met(segments_.size(), false);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    SegmentContact& segment = segments_[rows[k].segment];
    const double adhesion = segment.adhesion;
    segment = contacts[k];
    segment.adhesion = adhesion;
    met[rows[k].segment] = true;
  }
  for (std::size_t s = 0; s < segments_.size(); ++s)
    if (!met[s]) // no soil is there
      segments_[s].normal_impulse = segments_[s].tangential_impulse = segments_[s].water_impulse = 0.0;

  std::vector<double> v(step.trial().size(), 0.0);
  for (const SegmentRows& of : rows)
    for (const auto& [dof, velocity] : of.beam)
      v[dof] += dot(velocity, impulse(of));
  step.answer(v);
  for (std::size_t i = 0; i < v.size(); ++i)
    v[i] += step.trial()[i];
  return v;
}

Vector LiningContact::impulse(const SegmentRows& rows) const {
  const SegmentContact& segment = segments_[rows.segment];
  const Vector t = rows.tangent();
  return {segment.normal_impulse * rows.normal.x + segment.tangential_impulse * t.x,
          segment.normal_impulse * rows.normal.y + segment.tangential_impulse * t.y};
}

std::vector<NodeChange> LiningContact::changes(std::span<const SegmentRows> rows,
                                               const SoilMotion& soil) const {
  std::vector<NodeChange> changes;
  for (const SegmentRows& of : rows)
    add_impulse(of, impulse(of), changes);
  find_changes(soil, changes);
  return changes;
}

void LiningContact::follow_gaps(std::span<const SegmentRows> rows, const SoilMotion& soil,
                                std::span<const double> v, double dt) {
  const std::vector<double> closing = closing_speeds(rows, soil, v);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    double& gap = gaps_[rows[k].segment];
    gap = segments_[rows[k].segment].tied ? 0.0 : std::max(0.0, gap - dt * closing[2 * k]);
  }
}

std::vector<NodeChange> LiningContact::stopped(std::span<const SegmentRows> rows, const SoilMotion& soil,
                                               std::span<const double> v) const {
  const std::vector<double> closing = closing_speeds(rows, soil, v);
  std::vector<std::size_t> stopped;
  for (std::size_t row = 0; row < closing.size(); ++row) {
    const SegmentContact& segment = segments_[rows[row / 2].segment];
    if (segment.tied && (row % 2 == 0 || segment.slip == 0))
      stopped.push_back(row);
  }
  const auto count = static_cast<Eigen::Index>(stopped.size());
  Eigen::MatrixXd g(count, count);
  Eigen::VectorXd speeds(count);
  for (std::size_t r = 0; r < stopped.size(); ++r) {
    speeds(static_cast<Eigen::Index>(r)) = closing[stopped[r]];
    for (std::size_t c = 0; c <= r; ++c)
      g(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) =
          soil_answer_[stopped[r] * closing.size() + stopped[c]];
  }
  const Eigen::VectorXd impulses = g.selfadjointView<Eigen::Lower>().llt().solve(speeds);
  std::vector<NodeChange> changes;
  for (std::size_t k = 0; k < stopped.size(); ++k) {
    const Vector along = direction(rows, stopped[k]);
    const double j = impulses(static_cast<Eigen::Index>(k));
    add_impulse(rows[stopped[k] / 2], {j * along.x, j * along.y}, changes);
  }
  find_changes(soil, changes);
  return changes;
}

std::vector<double> LiningContact::state() const {
  std::vector<double> state;
  for (std::size_t s = 0; s < segments_.size(); ++s)
    state.insert(state.end(),
                 {gaps_[s], segments_[s].tied ? 1.0 : 0.0, static_cast<double>(segments_[s].slip)});
  return state;
}

void LiningContact::set_state(std::span<const double> state) {
  constexpr std::size_t numbers = 3; // of a segment
  if (state.size() != numbers * segments_.size())
    throw std::runtime_error(
        fmt::format("the checkpoint holds {} numbers of the contact of a lining that has {}", state.size(),
                    numbers * segments_.size()));
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    gaps_[s] = state[numbers * s];
    segments_[s].tied = state[numbers * s + 1] != 0.0;
    segments_[s].slip = static_cast<int>(state[numbers * s + 2]);
  }
}

} // namespace tremolo::mpm_domain
