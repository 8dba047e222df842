#include "mpm_domain/lining/beam/beam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// Numbers of the nodes in the order that their degrees of freedom take.
std::vector<std::size_t> numbering(std::size_t nodes, bool closed) {
  if (closed)
    return numbers_of_ring(nodes);
  std::vector<std::size_t> order(nodes);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

void require(const BeamShape& shape) {
  const std::size_t least = shape.closed ? 3 : 2;
  if (shape.nodes.size() < least)
    throw std::invalid_argument(
        fmt::format("a beam has {} nodes; allowed: {} or more", shape.nodes.size(), least));
  for (const std::size_t hinge : shape.hinges)
    if (hinge >= shape.nodes.size() || (!shape.closed && (hinge == 0 || hinge + 1 == shape.nodes.size())))
      throw std::invalid_argument(
          fmt::format("a beam of {} nodes has a hinge at node {}; a hinge stands between two elements",
                      shape.nodes.size(), hinge));
}

} // namespace

Beam::Beam(const BeamShape& shape, const BeamSection& section)
    : section_(section), first_dof_(shape.nodes.size()) {
  require(shape);
  const std::size_t nodes = shape.nodes.size();
  const auto is_hinge = [&](std::size_t node) {
    return std::ranges::find(shape.hinges, node) != shape.hinges.end();
  };
  for (const std::size_t node : numbering(nodes, shape.closed)) {
    first_dof_[node] = q_.size();
    q_.insert(q_.end(), {shape.nodes[node].x, shape.nodes[node].y, 0.0});
    if (is_hinge(node))
      q_.push_back(0.0);
  }
  v_.assign(q_.size(), 0.0);
  masses_.assign(q_.size(), 0.0);
  for (std::size_t k = 0; k < (shape.closed ? nodes : nodes - 1); ++k) {
    const std::size_t next = (k + 1) % nodes;
    const Vector chord = shape.nodes[next] - shape.nodes[k];
    const double length = std::hypot(chord.x, chord.y);
    if (!(length > 0.0))
      throw std::invalid_argument(
          fmt::format("nodes {} and {} of a beam stand at the same place, x = {:.6g} m, y = {:.6g} m", k,
                      next, shape.nodes[k].x, shape.nodes[k].y));
    const std::size_t a = first_dof_[k];
    const std::size_t b = first_dof_[next];
    elements_.push_back({.dofs = {a, a + 1, a + (is_hinge(k) ? 3 : 2), b, b + 1, b + 2},
                         .length = length,
                         .angle = std::atan2(chord.y, chord.x)});
    for (std::size_t i = 0; i < 6; ++i)
      masses_[elements_.back().dofs[i]] += 0.5 * length * (i % 3 == 2 ? section.rotary : section.mass);
  }
  now_.resize(elements_.size());
  follow_positions();
}

void Beam::follow_positions() {
  for (std::size_t e = 0; e < elements_.size(); ++e)
    now_[e] = position_of(elements_[e], q_);
}

double Beam::mass() const {
  double mass = 0.0;
  for (const std::size_t x : first_dof_)
    mass += masses_[x];
  return mass;
}

double Beam::kinetic_energy() const {
  double twice = 0.0;
  for (std::size_t i = 0; i < v_.size(); ++i)
    twice += masses_[i] * v_[i] * v_[i];
  return 0.5 * twice;
}

double Beam::strain_energy() const {
  double twice = 0.0;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const ElementStrain& strain = now_[e].strain;
    const ElementForce force = force_of(elements_[e], section_, strain);
    for (std::size_t i = 0; i < 3; ++i)
      twice += strain[i] * force[i];
  }
  return 0.5 * twice;
}

SectionForces Beam::forces(std::size_t element) const {
  const ElementPosition& now = now_[element];
  return in_the_middle(force_of(elements_[element], section_, now.strain), now.length);
}

std::vector<double> Beam::internal_forces() const {
  std::vector<double> f(q_.size(), 0.0);
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const ElementForce force = force_of(elements_[e], section_, now_[e].strain);
    const auto b = now_[e].strain_rows();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        f[elements_[e].dofs[j]] += b[i][j] * force[i];
  }
  return f;
}

void Beam::add_stiffness(double factor, BandMatrix& to) const {
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const BeamElement& element = elements_[e];
    const auto b = now_[e].strain_rows();
    const auto d = stiffness_of(element, section_);
    std::array<std::array<double, 6>, 3> db{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t j = 0; j < 6; ++j)
          db[i][j] += factor * d[i][k] * b[k][j];
    for (std::size_t r = 0; r < 6; ++r)
      for (std::size_t c = 0; c < 6; ++c)
        if (element.dofs[r] >= element.dofs[c])
          to.add(element.dofs[r], element.dofs[c],
                 b[0][r] * db[0][c] + b[1][r] * db[1][c] + b[2][r] * db[2][c]);
  }
}

BandMatrix Beam::empty_matrix() const {
  std::size_t width = 0;
  for (const BeamElement& element : elements_) {
    const auto [least, most] = std::ranges::minmax(element.dofs);
    width = std::max(width, most - least);
  }
  return {q_.size(), width};
}

void Beam::set_velocities(std::span<const double> v) {
  std::ranges::copy(v, v_.begin());
}

void Beam::move(double dt) {
  for (std::size_t i = 0; i < q_.size(); ++i)
    q_[i] += dt * v_[i];
  follow_positions();
}

void Beam::strain_in_place(double dt) {
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const auto b = now_[e].strain_rows();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        elements_[e].strain_before[i] += dt * b[i][j] * v_[elements_[e].dofs[j]];
  }
  follow_positions();
}

std::vector<double> Beam::state() const {
  std::vector<double> state(q_);
  state.insert(state.end(), v_.begin(), v_.end());
  for (const BeamElement& element : elements_)
    state.insert(state.end(), element.strain_before.begin(), element.strain_before.end());
  return state;
}

void Beam::set_state(std::span<const double> state) {
  const std::size_t wanted = 2 * q_.size() + 3 * elements_.size();
  if (state.size() != wanted)
    throw std::runtime_error(
        fmt::format("the checkpoint holds {} numbers of a beam that has {}", state.size(), wanted));
  const auto v = state.begin() + static_cast<std::ptrdiff_t>(q_.size());
  std::copy(state.begin(), v, q_.begin());
  std::copy_n(v, v_.size(), v_.begin());
  auto from = v + static_cast<std::ptrdiff_t>(v_.size());
  for (BeamElement& element : elements_)
    for (double& strain : element.strain_before)
      strain = *from++;
  follow_positions();
}

} // namespace tremolo::mpm_domain
