#include "mpm_domain/boundary/layer/layer_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

using eq6::Vector;

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
  damping_.resize(nodes);
  for (std::vector<Vector>* field : {&end_dashpot_, &u_, &v_, &z_, &force_})
    field->resize(nodes);
  memory_.resize(BilinearElement::points * rows * shape_.columns.size());
  lump();
}

void LayerLattice::lump() {
  const auto rows = static_cast<std::size_t>(shape_.cells);
  const double height = shape_.depth / shape_.cells;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < shape_.columns.size(); ++i)
      for (const std::size_t n : {node(i, j), node(i + 1, j), node(i, j + 1), node(i + 1, j + 1)})
        mass_[n] += 0.25 * shape_.columns[i].density * shape_.columns[i].width * height;
  for (std::size_t j = 0; j <= rows; ++j)
    for (std::size_t i = 0; i < across_; ++i)
      damping_[node(i, j)] = stretch_.rate(static_cast<double>(j) * height);
  for (const std::size_t end : {0UL, 1UL}) {
    if (shape_.ends[end] != LayerEnd::dashpots)
      continue;
    const LayerColumn& column = end == 0 ? shape_.columns.front() : shape_.columns.back();
    for (std::size_t j = 1; j < rows; ++j)
      end_dashpot_[node(end == 0 ? 0 : across_ - 1, j)] = {
          height * std::sqrt(column.density * column.p_modulus),
          height * std::sqrt(column.density * column.shear_modulus)};
  }
}

void LayerLattice::advance(double dt, std::span<const Vector> boundary_velocity, WorkerPool& workers) {
  move(dt, boundary_velocity, workers);
  sum_forces(dt, workers);
}

// Leapfrog, damping centred: (m/dt + c/2) w+ = (m/dt - c/2) w- + f + k Z, where c = m b + C and k = m b a - b
// C with C the dashpots of an end, which the stretch turns into C (w + b Z).
void LayerLattice::move(double dt, std::span<const Vector> boundary_velocity, WorkerPool& workers) {
  const double a = stretch_.shift();
  const Decay decay(a, dt);
  const auto move_node = [&](std::size_t n) {
    const double rate = mass_[n] / dt;
    const double b = damping_[n];
    const auto kicked = [&](double v, double f, double z, double dashpot) {
      const double c = 0.5 * (mass_[n] * b + dashpot);
      return ((rate - c) * v + f + b * (mass_[n] * a - dashpot) * z) / (rate + c);
    };
    if (n < across_)
      v_[n] = boundary_velocity[n];
    else if (!is_led(n))
      v_[n] = {kicked(v_[n].x, force_[n].x, z_[n].x, end_dashpot_[n].x),
               kicked(v_[n].y, force_[n].y, z_[n].y, end_dashpot_[n].y)};
    u_[n] = {u_[n].x + dt * v_[n].x, u_[n].y + dt * v_[n].y};
    z_[n] = {decay.keep * z_[n].x + decay.gain * v_[n].x, decay.keep * z_[n].y + decay.gain * v_[n].y};
  };
  workers.run(static_cast<std::size_t>(shape_.cells), [&](std::size_t row) { // all but the fixed end
    for (std::size_t n = row * across_; n < (row + 1) * across_; ++n)
      move_node(n);
  });
}

void LayerLattice::sum_forces(double dt, WorkerPool& workers) {
  constexpr std::size_t columns_per_block = 16;
  const auto rows = static_cast<std::size_t>(shape_.cells);
  const std::size_t columns = shape_.columns.size();
  const double height = shape_.depth / shape_.cells;
  const double shift = stretch_.shift();
  const Decay stress_decay(shift, dt);
  std::vector<StrainDecays> strain_decays;
  for (std::size_t row = 0; row < rows; ++row) {
    const auto decay_at = [&](double zeta) {
      return Decay(shift + stretch_.rate((static_cast<double>(row) + zeta) * height), dt);
    };
    strain_decays.push_back({decay_at(BilinearElement::gauss[0]), decay_at(BilinearElement::gauss[1])});
  }
  std::ranges::fill(force_, Vector{});
  std::size_t blocks = std::max<std::size_t>(1, columns / columns_per_block);
  if (shape_.ends[0] == LayerEnd::repeated && blocks % 2 == 1 && blocks > 1)
    --blocks; // The last block shares nodes with the first, so they must have different colours.
  for (std::size_t colour = 0; colour < 2; ++colour)
    workers.run((blocks + 1 - colour) / 2, [&](std::size_t task) {
      const std::size_t block = 2 * task + colour;
      for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = columns * block / blocks; column < columns * (block + 1) / blocks; ++column)
          strain_element(column, row, stress_decay, strain_decays[row]);
    });
}

void LayerLattice::strain_element(std::size_t column, std::size_t row, const Decay& stress_decay,
                                  const StrainDecays& strain_decays) {
  const auto& [width, density, p_modulus, shear] = shape_.columns[column];
  const double lame = p_modulus - 2.0 * shear;
  const double height = shape_.depth / shape_.cells;
  const std::array<std::size_t, 4> nodes{node(column, row), node(column + 1, row), node(column, row + 1),
                                         node(column + 1, row + 1)};
  const BilinearElement element{width, height};
  const BilinearElement::Vectors u{u_[nodes[0]], u_[nodes[1]], u_[nodes[2]], u_[nodes[3]]};
  BilinearElement::Vectors force{};
  Memory* memory = &memory_[BilinearElement::points * (row * shape_.columns.size() + column)];
  for (std::size_t g = 0; g < BilinearElement::gauss.size(); ++g) {
    const double zeta = BilinearElement::gauss[g];
    const double b = stretch_.rate((static_cast<double>(row) + zeta) * height);
    const Vector ux = element.along(u, zeta);
    for (const double xi : BilinearElement::gauss) {
      const Vector uz = element.down(u, xi);
      const Vector q = remember(memory->q, strain_decays[g], uz);
      const Vector e = {uz.x - b * q.x, uz.y - b * q.y};
      const double sxz = shear * (e.x + ux.y);
      const Vector on_x = {p_modulus * ux.x + lame * e.y, sxz};
      const Vector on_z = {sxz, p_modulus * e.y + lame * ux.x};
      const Vector s = remember(memory->s, stress_decay, on_x);
      element.pull(force, xi, zeta, {on_x.x + b * s.x, on_x.y + b * s.y}, on_z);
      ++memory;
    }
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    force_[nodes[k]].x += force[k].x;
    force_[nodes[k]].y += force[k].y;
  }
}

LayerEndNodes LayerLattice::end_nodes(std::size_t end) const {
  LayerEndNodes nodes;
  for (std::size_t j = 0; j <= static_cast<std::size_t>(shape_.cells); ++j) {
    nodes.mass.push_back(mass_[end_node(end, j)]);
    nodes.force.push_back(force_[end_node(end, j)]);
  }
  return nodes;
}

void LayerLattice::add_corner_force(std::size_t end, Vector force) {
  Vector& sum = force_[end_node(end, 0)];
  sum = {sum.x + force.x, sum.y + force.y};
}

std::vector<double> LayerLattice::state() const {
  std::vector<double> all;
  for (const std::vector<Vector>* field : {&u_, &v_, &z_, &force_})
    for (const Vector& value : *field)
      all.insert(all.end(), {value.x, value.y});
  for (const Memory& memory : memory_)
    all.insert(all.end(), {memory.q.x, memory.q.y, memory.s.x, memory.s.y});
  return all;
}

void LayerLattice::restore(std::span<const double> state) {
  if (state.size() != 8 * u_.size() + 4 * memory_.size())
    throw std::invalid_argument("the state of a matched layer is that of another layer");
  auto next = state.begin();
  for (std::vector<Vector>* field : {&u_, &v_, &z_, &force_})
    for (Vector& value : *field)
      value = {*next++, *next++};
  for (Memory& memory : memory_)
    memory = {{*next++, *next++}, {*next++, *next++}};
}

} // namespace tremolo::mpm_domain
