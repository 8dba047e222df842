#include "mpm_domain/boundary/layer/layer_corner.hpp"

#include <algorithm>
#include <stdexcept>

namespace tremolo::mpm_domain {

LayerCorner::LayerCorner(const CornerShape& shape)
    : shape_(shape), cells_(static_cast<std::size_t>(shape.cells)), size_(shape.depth / shape.cells),
      mass_((cells_ + 1) * (cells_ + 1)), memory_(cells_ * cells_) {
  for (std::vector<Vector>* field : {&u_, &v_, &z_, &y_, &force_})
    field->resize(mass_.size());
  for (std::size_t j = 0; j < cells_; ++j)
    for (std::size_t i = 0; i < cells_; ++i)
      for (const std::size_t n : {node(i, j), node(i + 1, j), node(i, j + 1), node(i + 1, j + 1)})
        mass_[n] += 0.25 * shape_.density * size_ * size_;
}

void LayerCorner::advance(double dt, const Vector& corner_velocity, const LayerEndNodes& side,
                          const LayerEndNodes& base) {
  v_.front() = corner_velocity;
  u_.front() = u_.front() + dt * corner_velocity;
  for (std::size_t j = 0; j < cells_; ++j)
    for (std::size_t i = j == 0 ? 1 : 0; i < cells_; ++i) {
      const std::size_t n = node(i, j);
      double mass = mass_[n];
      Vector force = force_[n];
      if (j == 0 || i == 0) {
        const LayerEndNodes& layer = j == 0 ? side : base;
        mass += layer.mass[i + j];
        force += layer.force[i + j];
      }
      move_node(i, j, dt, mass, force);
    }
  sum_forces(dt);
}

// Leapfrog, damping centred: (m/dt + c) w+ = (m/dt - c) w- + f + m (a (b_x + b_z) Z - b_x b_z (Z - a Y)) with
// c = m (b_x + b_z)/2. Z and Y belong to the times of the forces.
void LayerCorner::move_node(std::size_t i, std::size_t j, double dt, double mass, Vector force) {
  const double bx = shape_.stretch.rate(static_cast<double>(i) * size_);
  const double bz = shape_.stretch.rate(static_cast<double>(j) * size_);
  const double a = shape_.stretch.shift();
  const Decay decay(a, dt);
  const std::size_t n = node(i, j);
  const auto kick = [&](double& u, double& v, double& z, double& y, double f) {
    const double c = 0.5 * (bx + bz);
    v = ((1.0 / dt - c) * v + f / mass + a * (bx + bz) * z - bx * bz * (z - a * y)) / (1.0 / dt + c);
    u += dt * v;
    const double before = z;
    z = decay.keep * z + decay.gain * v;
    y = decay.keep * y + decay.gain * 0.5 * (before + z);
  };
  kick(u_[n].x, v_[n].x, z_[n].x, y_[n].x, force.x);
  kick(u_[n].y, v_[n].y, z_[n].y, y_[n].y, force.y);
}

void LayerCorner::sum_forces(double dt) {
  std::ranges::fill(force_, Vector{});
  std::vector<StretchAt> stretches;
  for (std::size_t cell = 0; cell < cells_; ++cell)
    for (const double position : gauss)
      stretches.push_back(shape_.stretch.at((static_cast<double>(cell) + position) * size_, dt));
  const Decay stress_decay(shape_.stretch.shift(), dt);
  for (std::size_t row = 0; row < cells_; ++row)
    for (std::size_t column = 0; column < cells_; ++column)
      strain_element(column, row, stretches, stress_decay);
}

void LayerCorner::strain_element(std::size_t column, std::size_t row, std::span<const StretchAt> stretches,
                                 const Decay& stress_decay) {
  const double p_modulus = shape_.p_modulus, shear = shape_.shear_modulus;
  const double lame = p_modulus - 2.0 * shear;
  const std::array<std::size_t, 4> nodes{node(column, row), node(column + 1, row), node(column, row + 1),
                                         node(column + 1, row + 1)};
  const BilinearElement<Vector> element{size_, size_};
  const std::array<Vector, 4> u{u_[nodes[0]], u_[nodes[1]], u_[nodes[2]], u_[nodes[3]]};
  Memory& memory = memory_[row * cells_ + column];
  const StretchAt* across = &stretches[gauss.size() * column];
  const StretchAt* down = &stretches[gauss.size() * row];

  std::array<Vector, 2> on_x{}, on_z{}; // of each zeta, the sum of both xi, and of each xi that of both zeta
  for (std::size_t g = 0; g < gauss.size(); ++g) {
    const Vector ux = element.along(u, gauss[g]);
    for (std::size_t h = 0; h < gauss.size(); ++h) {
      const Vector uz = element.down(u, gauss[h]);
      auto& [qx, qz] = memory.q[gauss.size() * g + h];
      const Vector ex = ux - across[h].rate * remember(qx, across[h].decay, ux);
      const Vector ez = uz - down[g].rate * remember(qz, down[g].decay, uz);
      const double sxz = shear * (ez.x + ex.y);
      on_x[g] += Vector{p_modulus * ex.x + lame * ez.y, sxz};
      on_z[h] += Vector{sxz, p_modulus * ez.y + lame * ex.x};
    }
  }
  std::array<Vector, 4> force{};
  for (std::size_t g = 0; g < gauss.size(); ++g) {
    const Vector sx = remember(memory.sx[g], stress_decay, on_x[g]);
    const Vector sz = remember(memory.sz[g], stress_decay, on_z[g]);
    element.pull_across(force, gauss[g], on_x[g] + down[g].rate * sx);
    element.pull_down(force, gauss[g], on_z[g] + across[g].rate * sz);
  }
  for (std::size_t k = 0; k < nodes.size(); ++k)
    force_[nodes[k]] = force_[nodes[k]] + force[k];
}

void LayerCorner::add_state(SavedNumbers& state) {
  state.add(u_, v_, z_, y_, force_);
  for (Memory& memory : memory_) {
    for (auto& [qx, qz] : memory.q)
      state.add(qx, qz);
    for (std::size_t g = 0; g < gauss.size(); ++g)
      state.add(memory.sx[g], memory.sz[g]);
  }
}

} // namespace tremolo::mpm_domain
