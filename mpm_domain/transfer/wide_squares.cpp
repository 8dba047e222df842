#include "mpm_domain/transfer/wide_squares.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// l_L and l_T in cells, for 2, 3 and 4 particles a cell and direction.
struct Sides {
  double along, across;
};
Sides sides_of(double own) {
  constexpr std::array<Sides, 3> by_particles{{{0.44, 0.5}, {0.44, 0.417}, {0.44, 0.446}}};
  return by_particles.at(static_cast<std::size_t>(std::lround(0.5 / own)) - 2);
}

/// L in one direction, in cells.
/// @param place   of the particle in its cell
/// @param before  e_0
/// @param behind  e_3
double shrunk_side(double full, double own, double position, double before, double behind) {
  const double a = std::max(own, std::min(position, full));
  const double b = std::max(own, std::min(1.0 - position, full));
  return std::min(a + before * (full - a), b + behind * (full - b));
}

/// The nodes, among the four around a cell, that the wide box touches: from the first on up to before the
/// last.
struct Touched {
  int first, end;
};
Touched touched(double position, double across) {
  return {position < across ? 0 : 1, position > 1.0 - across ? 4 : 3};
}

} // namespace

WideSquares::WideSquares(const Particles& p, const Lattice& lattice, const NodeFields& nodes)
    : x_(p.x.data()), y_(p.y.data()), fullness_(nodes.fullness.data()),
      inside_block_(nodes.inside_block.data()), x_axis_(lattice.x0, lattice.h),
      y_axis_(lattice.y0, lattice.h), array_(lattice), first_(array_.first - array_.row - 1.0),
      row_(lattice.nx), own_(p.half_size / lattice.h), along_(sides_of(own_).along),
      across_(sides_of(own_).across), full_{{all(across_), x_axis_.per_h},
                                            {all(along_), x_axis_.per_h},
                                            {all(across_), x_axis_.per_h},
                                            {all(along_), x_axis_.per_h}},
      shrunk_(full_) {}

const WideBoxes& WideSquares::shrunk(const Lanes& xi, const Lanes& eta,
                                     const std::array<std::int32_t, 4>& first, std::size_t count) const {
  Lanes x_value = all(across_);
  Lanes x_slope = all(along_);
  Lanes y_value = x_value;
  Lanes y_slope = x_slope;
  for (std::size_t k = 0; k < count; ++k) {
    const Touched on_x = touched(xi[k], across_);
    const Touched on_y = touched(eta[k], across_);
    const double* const e = fullness_ + first[k];
    double left = 1.0, right = 1.0, below = 1.0, above = 1.0;
    for (int j = on_y.first; j < on_y.end; ++j) {
      left = std::min(left, e[j * row_]);
      right = std::min(right, e[j * row_ + 3]);
    }
    for (int i = on_x.first; i < on_x.end; ++i) {
      below = std::min(below, e[i]);
      above = std::min(above, e[3 * row_ + i]);
    }
    x_value[k] = shrunk_side(across_, own_, xi[k], left, right);
    x_slope[k] = shrunk_side(along_, own_, xi[k], left, right);
    y_value[k] = shrunk_side(across_, own_, eta[k], below, above);
    y_slope[k] = shrunk_side(along_, own_, eta[k], below, above);
  }
  const double per_h = x_axis_.per_h;
  shrunk_ = {{x_value, per_h}, {x_slope, per_h}, {y_value, per_h}, {y_slope, per_h}};
  return shrunk_;
}

} // namespace tremolo::mpm_domain
