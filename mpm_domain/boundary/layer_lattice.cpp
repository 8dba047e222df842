#include "mpm_domain/boundary/layer_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

using eq6::Vector;

/// What is left of the amplitude of a P wave that goes to the fixed end and back along the normal. Less would
/// ask for a steeper stretch, which elements reflect (docs/boundaries.md).
constexpr double returned = 1e-3;

/// a d/c_p: waves far slower than 1/a are let through to the fixed end, which then is 70 d away.
constexpr double shift_of_depth = 0.05;

double p_wave_speed(const LayerColumn& column) {
  return std::sqrt(column.p_modulus / column.density);
}

bool sound(const LayerColumn& column) {
  return column.width > 0.0 && column.density > 0.0 && column.shear_modulus > 0.0 &&
         column.p_modulus > column.shear_modulus && std::isfinite(column.p_modulus);
}

/// The two points of Gauss in [0, 1].
constexpr double near_point = 0.5 - 0.5 * std::numbers::inv_sqrt3;
constexpr std::array<double, 2> gauss{near_point, 1.0 - near_point};

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
  largest_stretch_ = -1.5 * fastest * std::log(returned) / shape_.depth;
  shift_ = shift_of_depth * fastest / shape_.depth;

  across_ = shape_.columns.size() + (repeated ? 0 : 1);
  const auto rows = static_cast<std::size_t>(shape_.cells);
  const std::size_t nodes = across_ * (rows + 1);
  mass_.resize(nodes);
  damping_.resize(nodes);
  for (std::vector<Vector>* field : {&end_dashpot_, &u_, &v_, &z_, &force_})
    field->resize(nodes);
  memory_.resize(points * rows * shape_.columns.size());
  lump();
}

double LayerLattice::stretch(double z) const {
  const double share = z / shape_.depth;
  return largest_stretch_ * share * share;
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
      damping_[node(i, j)] = stretch(static_cast<double>(j) * height);
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

void LayerLattice::advance(double dt, std::span<const Vector> boundary_velocity) {
  move(dt, boundary_velocity);
  sum_forces(dt);
}

// Leapfrog, damping centred: (m/dt + c/2) w+ = (m/dt - c/2) w- + f + k Z, where c = m b + C and k = m b a - b
// C with C the dashpots of an end, which the stretch turns into C (w + b Z).
void LayerLattice::move(double dt, std::span<const Vector> boundary_velocity) {
  const double keep = (1.0 - 0.5 * shift_ * dt) / (1.0 + 0.5 * shift_ * dt);
  const double gain = dt / (1.0 + 0.5 * shift_ * dt);
  const std::size_t moving = across_ * static_cast<std::size_t>(shape_.cells); // all but the fixed end
  for (std::size_t n = 0; n < moving; ++n) {
    const double rate = mass_[n] / dt;
    const double b = damping_[n];
    const auto kicked = [&](double v, double f, double z, double dashpot) {
      const double c = 0.5 * (mass_[n] * b + dashpot);
      return ((rate - c) * v + f + b * (mass_[n] * shift_ - dashpot) * z) / (rate + c);
    };
    v_[n] = n < across_ ? boundary_velocity[n]
                        : Vector{kicked(v_[n].x, force_[n].x, z_[n].x, end_dashpot_[n].x),
                                 kicked(v_[n].y, force_[n].y, z_[n].y, end_dashpot_[n].y)};
    u_[n] = {u_[n].x + dt * v_[n].x, u_[n].y + dt * v_[n].y};
    z_[n] = {keep * z_[n].x + gain * v_[n].x, keep * z_[n].y + gain * v_[n].y};
  }
}

void LayerLattice::sum_forces(double dt) {
  std::ranges::fill(force_, Vector{});
  for (std::size_t row = 0; row < static_cast<std::size_t>(shape_.cells); ++row)
    for (std::size_t column = 0; column < shape_.columns.size(); ++column)
      strain_element(column, row, dt);
}

// Memories live half a step after the present; what they are now is the mean of before and after.
void LayerLattice::strain_element(std::size_t column, std::size_t row, double dt) {
  const auto& [width, density, p_modulus, shear] = shape_.columns[column];
  const double lame = p_modulus - 2.0 * shear;
  const double height = shape_.depth / shape_.cells;
  const std::array<std::size_t, 4> nodes{node(column, row), node(column + 1, row), node(column, row + 1),
                                         node(column + 1, row + 1)};
  const Vector u00 = u_[nodes[0]], u10 = u_[nodes[1]], u01 = u_[nodes[2]], u11 = u_[nodes[3]];
  const double shift_keep = (1.0 - 0.5 * shift_ * dt) / (1.0 + 0.5 * shift_ * dt);
  const double shift_gain = dt / (1.0 + 0.5 * shift_ * dt);
  const double share = 0.25 * width * height;
  std::array<Vector, 4> force{};
  Memory* memory = &memory_[points * (row * shape_.columns.size() + column)];
  for (const double zeta : gauss) {
    const double b = stretch((static_cast<double>(row) + zeta) * height);
    const double rate = shift_ + b;
    const double keep = (1.0 - 0.5 * rate * dt) / (1.0 + 0.5 * rate * dt);
    const double gain = dt / (1.0 + 0.5 * rate * dt);
    const auto along = [&](double a, double c, double d, double e) {
      return ((1.0 - zeta) * (c - a) + zeta * (e - d)) / width;
    };
    const Vector ux = {along(u00.x, u10.x, u01.x, u11.x), along(u00.y, u10.y, u01.y, u11.y)};
    for (const double xi : gauss) {
      const auto down = [&](double a, double c, double d, double e) {
        return ((1.0 - xi) * (d - a) + xi * (e - c)) / height;
      };
      const Vector uz = {down(u00.x, u10.x, u01.x, u11.x), down(u00.y, u10.y, u01.y, u11.y)};
      const Vector q = {keep * memory->q.x + gain * uz.x, keep * memory->q.y + gain * uz.y};
      const Vector e = {uz.x - 0.5 * b * (memory->q.x + q.x), uz.y - 0.5 * b * (memory->q.y + q.y)};
      memory->q = q;
      const double sxx = p_modulus * ux.x + lame * e.y;
      const double szz = p_modulus * e.y + lame * ux.x;
      const double sxz = shear * (e.x + ux.y);
      const Vector s = {shift_keep * memory->s.x + shift_gain * sxx,
                        shift_keep * memory->s.y + shift_gain * sxz};
      const Vector across = {share / width * (sxx + 0.5 * b * (memory->s.x + s.x)),
                             share / width * (sxz + 0.5 * b * (memory->s.y + s.y))};
      memory->s = s;
      ++memory;
      const Vector through = {share / height * sxz, share / height * szz};
      const auto pull = [&](Vector& f, double nx, double nz) {
        f.x -= nx * across.x + nz * through.x;
        f.y -= nx * across.y + nz * through.y;
      };
      pull(force[0], zeta - 1.0, xi - 1.0);
      pull(force[1], 1.0 - zeta, -xi);
      pull(force[2], -zeta, 1.0 - xi);
      pull(force[3], zeta, xi);
    }
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    force_[nodes[k]].x += force[k].x;
    force_[nodes[k]].y += force[k].y;
  }
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
