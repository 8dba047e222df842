#include "mpm_domain/periodic_sides.hpp"

#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// act(image, real) for all images and the nodes that they stand for, row by row.
template <typename Act>
void for_images(Domain& domain, const Act& act) {
  const Grid& grid = domain.grid;
  domain.workers.run(static_cast<std::size_t>(grid.ny), [&](std::size_t row) {
    for (int i = 0; i < grid.nx; ++i)
      if (const int real = grid.real_column(i); real != i)
        act(grid.index(i, static_cast<int>(row)), grid.index(real, static_cast<int>(row)));
  });
}

void move(NodeField& field, std::size_t from, std::size_t to) {
  field[to] += field[from];
  field[from] = 0.0;
}

} // namespace

void fold_motion(Domain& domain) {
  Grid& grid = domain.grid;
  for_images(domain, [&](std::size_t image, std::size_t real) {
    for (NodeField* field : {&grid.mass, &grid.momentum_x, &grid.momentum_y})
      move(*field, image, real);
  });
}

void fold_forces(Domain& domain) {
  Grid& grid = domain.grid;
  for_images(domain, [&](std::size_t image, std::size_t real) {
    for (NodeField* field : {&grid.force_x, &grid.force_y, &grid.dashpot_x, &grid.dashpot_y})
      move(*field, image, real);
  });
}

void copy_to_images(Domain& domain) {
  Grid& grid = domain.grid;
  for_images(domain, [&](std::size_t image, std::size_t real) {
    for (NodeField* field : {&grid.vx, &grid.vy, &grid.vx_new, &grid.vy_new})
      (*field)[image] = (*field)[real];
    grid.acceleration[image] = grid.acceleration[real];
  });
}

void wrap(Particles& particles, const Box& box) {
  const double period = box.x_max - box.x_min;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const double shift = -period * std::floor((particles.x[k] - box.x_min) / period);
    particles.x[k] += shift;
    particles.x_initial[k] += shift;
  }
}

} // namespace tremolo::mpm_domain
