#include "mpm_domain/particles.hpp"

#include <fmt/format.h>

#include <numeric>
#include <stdexcept>

namespace tremolo::mpm_domain {

materials::Points Particles::points(std::size_t first, std::size_t count) {
  materials::Points points;
  points.count = count;
  points.sxx = sxx.data() + first;
  points.syy = syy.data() + first;
  points.szz = szz.data() + first;
  points.sxy = sxy.data() + first;
  points.state = state.data() + first * state_size;
  return points;
}

std::vector<std::vector<double>*> Particles::columns() {
  std::vector<std::vector<double>*> all{&x,   &y,   &vx,   &vy,     &sxx,       &syy,
                                        &szz, &sxy, &mass, &volume, &x_initial, &y_initial};
  if (!cxx.empty())
    all.insert(all.end(), {&cxx, &cxy, &cyx, &cyy});
  return all;
}

namespace {

std::size_t cell_of(const Particles& p, std::size_t k, const Grid& grid, double half_size) {
  const Weights wx = cell_weights(p.x[k], {grid.x0, grid.h, half_size});
  const Weights wy = gimp_weights(p.y[k], {grid.y0, grid.h, half_size});
  // A particle may move by one cell before the next sort, hence the margin; NaN fails every comparison.
  const bool inside = wx.base >= 1 && wx.base + 5 <= grid.nx && wy.base >= 1 && wy.base + 4 <= grid.ny;
  if (!inside || !std::isfinite(p.x[k]) || !std::isfinite(p.y[k]))
    throw std::runtime_error(fmt::format("particle {} of soil '{}' has left the grid: x = {:.6g} m, y = "
                                         "{:.6g} m; allowed x {:.6g} to {:.6g} m, y {:.6g} "
                                         "to {:.6g} m",
                                         p.id[k], p.soil, p.x[k], p.y[k], grid.x0 + 2 * grid.h,
                                         grid.x0 + (grid.nx - 3) * grid.h, grid.y0 + grid.h,
                                         grid.y0 + (grid.ny - 2) * grid.h));
  return grid.index(wx.base, wy.base);
}

} // namespace

void sort_by_cell(Particles& particles, const Grid& grid, double half_size) {
  const std::size_t n = particles.size();
  std::vector<std::size_t> cell(n);
  std::vector<std::size_t> start(grid.size() + 1, 0);
  for (std::size_t k = 0; k < n; ++k) {
    cell[k] = cell_of(particles, k, grid, half_size);
    ++start[cell[k] + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());

  const auto row_start = [&](int row) {
    return start[std::min(grid.size(), static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.nx))];
  };
  particles.block_start.clear();
  for (int row = 0; row < grid.ny; row += rows_per_block)
    particles.block_start.push_back(row_start(row));
  particles.block_start.push_back(n);

  std::vector<std::size_t> from(n);
  for (std::size_t k = 0; k < n; ++k)
    from[start[cell[k]]++] = k;

  std::vector<double> old;
  for (std::vector<double>* column : particles.columns()) {
    old = *column;
    for (std::size_t k = 0; k < n; ++k)
      (*column)[k] = old[from[k]];
  }
  old = particles.state;
  const std::size_t width = particles.state_size;
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t s = 0; s < width; ++s)
      particles.state[k * width + s] = old[from[k] * width + s];
  const std::vector<std::uint32_t> old_id = particles.id;
  particles.index_of.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    particles.id[k] = old_id[from[k]];
    particles.index_of[particles.id[k]] = static_cast<std::uint32_t>(k);
  }
}

} // namespace tremolo::mpm_domain
