#include "mpm_domain/lining/lining_contact.hpp"

#include "base/lanes.hpp"
#include "mpm_domain/lining/beam/beam_step.hpp"

#include <Eigen/Core>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// n of the even rows of a system, t of the odd ones.
Vector direction(std::span<const SegmentRows> rows, std::size_t row) {
  return row % 2 == 0 ? rows[row / 2].normal : rows[row / 2].tangent();
}

/// X = A^-1 H^T, a row for each degree of freedom of the beam.
std::vector<double> motions_by_impulses(std::span<const SegmentRows> rows, const BeamStep& step) {
  const std::size_t size = 2 * rows.size();
  std::vector<double> x(step.trial().size() * size, 0.0);
  for (std::size_t c = 0; c < size; ++c)
    for (const auto& [dof, velocity] : rows[c / 2].beam)
      x[dof * size + c] = dot(velocity, direction(rows, c));
  step.answer(x, size);
  return x;
}

/// Some columns of the two rows of H X of a segment, which stay in registers.
template <class Group, class InMemory, std::size_t Count>
void add_rows(const SegmentRows& rows, const double* x, std::size_t size, double* to) {
  std::array<Group, Count> of_normal{}, of_tangent{};
  const Vector t = rows.tangent();
  for (const auto& [dof, velocity] : rows.beam) {
    const double along_normal = dot(velocity, rows.normal);
    const double along_tangent = dot(velocity, t);
    const auto* const from = reinterpret_cast<const InMemory*>(x + dof * size);
#pragma GCC unroll 8
    for (std::size_t g = 0; g < Count; ++g) {
      of_normal[g] += along_normal * from[g];
      of_tangent[g] += along_tangent * from[g];
    }
  }
#pragma GCC unroll 8
  for (std::size_t g = 0; g < Count; ++g) {
    reinterpret_cast<InMemory*>(to)[g] = of_normal[g];
    reinterpret_cast<InMemory*>(to + size)[g] = of_tangent[g];
  }
}

/// H X, row after row.
std::vector<double> beam_answer(std::span<const SegmentRows> rows, std::span<const double> x) {
  const std::size_t size = 2 * rows.size();
  std::vector<double> g(size * size);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    double* const to = &g[2 * k * size];
    std::size_t c = 0;
    for (; c + 16 <= size; c += 16)
      add_rows<Lanes, LanesInMemory, 4>(rows[k], x.data() + c, size, to + c);
    for (; c < size; c += 2)
      add_rows<double, double, 2>(rows[k], x.data() + c, size, to + c);
  }
  return g;
}

/// B w - H v in the directions of all rows.
std::vector<double> closing_speeds(std::span<const SegmentRows> rows, const SoilMotion& soil,
                                   std::span<const double> v) {
  std::vector<double> closing;
  for (const SegmentRows& of : rows) {
    const Vector speed = soil_velocity(of, soil.vx, soil.vy) - beam_velocity(of, v);
    closing.push_back(dot(of.normal, speed));
    closing.push_back(dot(of.tangent(), speed));
  }
  return closing;
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
  soil_ = SegmentSoil(rows, soil);
  const std::vector<double> motions = motions_by_impulses(rows, step);
  std::vector<double> answer = beam_answer(rows, motions);
  SegmentWater borne;
  if (!water.nodes.empty())
    borne = find_segment_water(rows, water.nodes, answer, step.trial());
  soil_.add_answer(answer);
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

  std::vector<double> v = step.trial();
  Eigen::VectorXd impulses(2 * std::ssize(rows));
  for (std::size_t k = 0; k < rows.size(); ++k)
    impulses.segment<2>(2 * static_cast<Eigen::Index>(k)) << contacts[k].normal_impulse,
        contacts[k].tangential_impulse;
  using RowAfterRow = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<Eigen::VectorXd>(v.data(), std::ssize(v)) +=
      Eigen::Map<const RowAfterRow>(motions.data(), std::ssize(v), impulses.size()) * impulses;
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
  std::vector<Vector> impulses;
  for (const SegmentRows& of : rows)
    impulses.push_back(impulse(of));
  return soil_.changes(impulses, soil);
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
  std::vector<bool> stopped;
  for (const SegmentRows& of : rows) {
    const SegmentContact& segment = segments_[of.segment];
    stopped.insert(stopped.end(), {segment.tied, segment.tied && segment.slip == 0});
  }
  const std::vector<double> along = soil_.stop(closing, stopped);
  std::vector<Vector> impulses;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Vector n = rows[k].normal;
    const Vector t = rows[k].tangent();
    impulses.push_back(
        {along[2 * k] * n.x + along[2 * k + 1] * t.x, along[2 * k] * n.y + along[2 * k + 1] * t.y});
  }
  return soil_.changes(impulses, soil);
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
