#include "mpm_domain/grid/tied_nodes.hpp"

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

void fold(Domain& domain, std::initializer_list<NodeField*> fields) {
  if (domain.mesh)
    domain.workers.run(fields.size(), [&](std::size_t task) {
      domain.mesh->prolongation().restrict(*fields.begin()[task]);
    });
  else
    for_images(domain, [&](std::size_t image, std::size_t real) {
      for (NodeField* field : fields)
        move(*field, image, real);
    });
}

} // namespace

void fold_motion(Domain& domain) {
  Grid& grid = domain.grid;
  fold(domain, {&grid.mass, &grid.momentum_x, &grid.momentum_y});
}

void fold_momentum(Domain& domain) {
  fold(domain, {&domain.grid.momentum_x, &domain.grid.momentum_y});
}

void fold_forces(Domain& domain) {
  Grid& grid = domain.grid;
  fold(domain, {&grid.force_x, &grid.force_y, &grid.dashpot_x, &grid.dashpot_y});
}

void copy_to_tied(Domain& domain, std::initializer_list<NodeField*> fields) {
  if (domain.mesh)
    domain.workers.run(fields.size(),
                       [&](std::size_t task) { domain.mesh->prolongation().prolong(*fields.begin()[task]); });
  else
    for_images(domain, [&](std::size_t image, std::size_t real) {
      for (NodeField* field : fields)
        (*field)[image] = (*field)[real];
    });
}

} // namespace tremolo::mpm_domain
