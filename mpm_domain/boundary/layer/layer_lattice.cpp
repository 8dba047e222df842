#include "mpm_domain/boundary/layer/layer_lattice.hpp"

#include "mpm_domain/kernel/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// A vector of each of four elements side by side.
struct LaneVector {
  Lanes x, y;
};

double p_wave_speed(const LayerColumn& column) {
  return std::sqrt(column.p_modulus / column.density);
}

bool sound(const LayerColumn& column) {
  return column.width > 0.0 && column.density > 0.0 && column.shear_modulus > 0.0 &&
         column.p_modulus > column.shear_modulus && std::isfinite(column.p_modulus);
}

} // namespace

LayerLattice::LayerLattice(LayerShape shape) : shape_(std::move(shape)) {
  if (shape_.columns.empty() || shape_.cells < 1 || !(shape_.depth > 0.0))
    throw std::invalid_argument("a matched layer needs columns, cells and a depth");
  if (!std::ranges::all_of(shape_.columns, sound))
    throw std::invalid_argument("a matched layer needs elastic ground of positive density and moduli");
  const bool repeated = shape_.ends[0] == LayerEnd::repeated;
  if (repeated != (shape_.ends[1] == LayerEnd::repeated))
    throw std::invalid_argument("a matched layer repeats itself beyond both of its ends or neither");
  double fastest = 0.0;
  for (const LayerColumn& column : shape_.columns)
    fastest = std::max(fastest, p_wave_speed(column));
  stretch_ = LayerStretch(shape_.depth, shape_.fastest.value_or(fastest));

  across_ = shape_.columns.size() + (repeated ? 0 : 1);
  const auto rows = static_cast<std::size_t>(shape_.cells);
  const std::size_t nodes = across_ * (rows + 1);
  mass_.resize(nodes);
  for (NodeVectors* field : {&end_dashpot_, &u_, &v_, &z_, &force_}) {
    field->x.resize(nodes);
    field->y.resize(nodes);
  }
  for (const LayerColumn& column : shape_.columns) {
    p_modulus_.push_back(column.p_modulus);
    shear_modulus_.push_back(column.shear_modulus);
    width_.push_back(column.width);
  }
  memory_.resize(memories * rows * shape_.columns.size());
  lump();
}

void LayerLattice::lump() {
  const auto rows = static_cast<std::size_t>(shape_.cells);
  const double height = shape_.depth / shape_.cells;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < shape_.columns.size(); ++i)
      for (const std::size_t n : {node(i, j), node(i + 1, j), node(i, j + 1), node(i + 1, j + 1)})
        mass_[n] += 0.25 * shape_.columns[i].density * shape_.columns[i].width * height;
  for (const std::size_t end : {0UL, 1UL}) {
    if (shape_.ends[end] != LayerEnd::dashpots)
      continue;
    const LayerColumn& column = end == 0 ? shape_.columns.front() : shape_.columns.back();
    for (std::size_t j = 1; j < rows; ++j)
      end_dashpot_.set(end_node(end, j), {height * std::sqrt(column.density * column.p_modulus),
                                          height * std::sqrt(column.density * column.shear_modulus)});
  }
}

void LayerLattice::advance(double dt, std::span<const Vector> boundary_velocity, WorkerPool& workers) {
  move(dt, boundary_velocity, workers);
  sum_forces(dt, workers);
}

void LayerLattice::move(double dt, std::span<const Vector> boundary_velocity, WorkerPool& workers) {
  const Decay decay(stretch_.shift(), dt);
  const auto rows = static_cast<std::size_t>(shape_.cells);
  workers.run(rows + 1, [&](std::size_t row) {
    if (row == 0)
      for (std::size_t n = 0; n < across_; ++n)
        v_.set(n, boundary_velocity[n]);
    else if (row < rows)
      kick_row(row, dt);
    by_fours(row * across_, (row + 1) * across_, [&](std::size_t n, auto group) {
      const auto follow = [&](double& u, double& z, double& force, const double& velocity) {
        const Lanes v = group.load(&velocity); // zero at the fixed end
        group.store(&u, group.load(&u) + dt * v);
        group.store(&z, decay.keep * group.load(&z) + decay.gain * v);
        group.store(&force, Lanes{}); // it has acted
      };
      follow(u_.x[n], z_.x[n], force_.x[n], v_.x[n]);
      follow(u_.y[n], z_.y[n], force_.y[n], v_.y[n]);
    });
  });
}

// Leapfrog, damping centred: (m/dt + c/2) w+ = (m/dt - c/2) w- + f + k Z, where c = m b + C and k = m b a - b
// C with C the dashpots of an end, which the stretch turns into C (w + b Z).
void LayerLattice::kick_row(std::size_t row, double dt) {
  const double a = stretch_.shift();
  const double b = stretch_.rate(static_cast<double>(row) * shape_.depth / shape_.cells);
  const std::size_t first = row * across_ + (shape_.ends[0] == LayerEnd::corner ? 1 : 0);
  const std::size_t last = (row + 1) * across_ - (shape_.ends[1] == LayerEnd::corner ? 1 : 0);
  const double steps_a_second = 1.0 / dt;
  by_fours(first, last, [&](std::size_t n, auto group) {
    const Lanes mass = group.present(group.load(&mass_[n]), all(1.0));
    const Lanes rate = steps_a_second * mass;
    const auto kick = [&](double& velocity, const double& force, const double& memory,
                          const double& dashpot) {
      const Lanes c = 0.5 * (b * mass + group.load(&dashpot));
      const Lanes k = b * (a * mass - group.load(&dashpot));
      const Lanes kept = (rate - c) * group.load(&velocity);
      group.store(&velocity, (kept + group.load(&force) + k * group.load(&memory)) / (rate + c));
    };
    kick(v_.x[n], force_.x[n], z_.x[n], end_dashpot_.x[n]);
    kick(v_.y[n], force_.y[n], z_.y[n], end_dashpot_.y[n]);
  });
}

void LayerLattice::sum_forces(double dt, WorkerPool& workers) {
  constexpr std::size_t columns_per_block = 16;
  const std::size_t columns = shape_.columns.size();
  const double height = shape_.depth / shape_.cells;
  std::vector<Row> rows;
  for (std::size_t row = 0; row < static_cast<std::size_t>(shape_.cells); ++row) {
    const auto stretch_at = [&](double zeta) {
      return stretch_.at((static_cast<double>(row) + zeta) * height, dt);
    };
    rows.push_back({row, {stretch_at(gauss[0]), stretch_at(gauss[1])}, Decay(stretch_.shift(), dt)});
  }
  std::size_t blocks = std::max<std::size_t>(1, columns / columns_per_block);
  if (shape_.ends[0] == LayerEnd::repeated && blocks % 2 == 1 && blocks > 1)
    --blocks; // The last block shares nodes with the first, so they must have different colours.
  for (std::size_t colour = 0; colour < 2; ++colour)
    workers.run((blocks + 1 - colour) / 2, [&](std::size_t task) {
      const std::size_t block = 2 * task + colour;
      for (const Row& row : rows)
        strain(row, columns * block / blocks, columns * (block + 1) / blocks);
    });
}

void LayerLattice::strain(const Row& row, std::size_t first_column, std::size_t last_column) {
  // The last column of a layer that repeats itself ends at the nodes of the first.
  const bool wraps = last_column == across_;
  by_fours(first_column, last_column - (wraps ? 1 : 0),
           [&](std::size_t column, auto group) { strain_elements(row, column, group); });
  if (wraps)
    strain_elements(row, last_column - 1, FewerThanFour(1));
}

template <typename Group>
void LayerLattice::strain_elements(const Row& row, std::size_t column, Group group) {
  const Lanes shear = group.load(&shear_modulus_[column]);
  const Lanes p_modulus = group.load(&p_modulus_[column]);
  const Lanes lame = p_modulus - 2.0 * shear;
  const std::array<std::size_t, 4> nodes{node(column, row.index), node(column + 1, row.index),
                                         node(column, row.index + 1), node(column + 1, row.index + 1)};
  const BilinearElement<LaneVector> element{group.present(group.load(&width_[column]), all(1.0)),
                                            shape_.depth / shape_.cells};
  std::array<LaneVector, 4> u{};
  for (std::size_t k = 0; k < nodes.size(); ++k)
    u[k] = {group.load(&u_.x[nodes[k]]), group.load(&u_.y[nodes[k]])};
  const std::size_t columns = shape_.columns.size();
  double* memory = &memory_[memories * row.index * columns + column];
  const auto recall = [&](const Decay& decay, const LaneVector& now) {
    LaneVector kept{group.load(memory), group.load(memory + columns)};
    const LaneVector mean = remember(kept, decay, now);
    group.store(memory, kept.x);
    group.store(memory + columns, kept.y);
    memory += 2 * columns;
    return mean;
  };
  const auto add = [](LaneVector& sum, const LaneVector& by) { sum = {sum.x + by.x, sum.y + by.y}; };

  const std::array<LaneVector, 2> uz{element.down(u, gauss[0]), element.down(u, gauss[1])};
  std::array<LaneVector, 2> ez_of_xi{}; // the sum of both depths
  LaneVector ux_of_depths{};
  std::array<LaneVector, 4> force{};
  for (std::size_t g = 0; g < gauss.size(); ++g) {
    const auto& [b, decay] = row.stretches[g];
    LaneVector ez{}; // of both xi
    for (std::size_t h = 0; h < gauss.size(); ++h) {
      const LaneVector q = recall(decay, uz[h]);
      const LaneVector e{uz[h].x - b * q.x, uz[h].y - b * q.y};
      add(ez, e);
      add(ez_of_xi[h], e);
    }
    const LaneVector ux = element.along(u, gauss[g]);
    add(ux_of_depths, ux);
    const LaneVector on_x{2.0 * p_modulus * ux.x + lame * ez.y, shear * (ez.x + 2.0 * ux.y)};
    const LaneVector s = recall(row.stress_decay, on_x);
    element.pull_across(force, gauss[g], {on_x.x + b * s.x, on_x.y + b * s.y});
  }
  for (std::size_t h = 0; h < gauss.size(); ++h)
    element.pull_down(
        force, gauss[h],
        {shear * (ez_of_xi[h].x + ux_of_depths.y), p_modulus * ez_of_xi[h].y + lame * ux_of_depths.x});
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    group.store(&force_.x[nodes[k]], group.load(&force_.x[nodes[k]]) + force[k].x);
    group.store(&force_.y[nodes[k]], group.load(&force_.y[nodes[k]]) + force[k].y);
  }
}

LayerEndNodes LayerLattice::end_nodes(std::size_t end) const {
  LayerEndNodes nodes;
  for (std::size_t j = 0; j <= static_cast<std::size_t>(shape_.cells); ++j) {
    nodes.mass.push_back(mass_[end_node(end, j)]);
    nodes.force.push_back(force_.at(end_node(end, j)));
  }
  return nodes;
}

void LayerLattice::add_corner_force(std::size_t end, Vector force) {
  force_.x[end_node(end, 0)] += force.x;
  force_.y[end_node(end, 0)] += force.y;
}

void LayerLattice::add_state(SavedNumbers& state) {
  for (NodeVectors* field : {&u_, &v_, &z_, &force_})
    state.add(field->x, field->y);
  state.add(memory_);
}

} // namespace tremolo::mpm_domain
