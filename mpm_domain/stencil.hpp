#pragma once

#include "mpm_domain/kernel.hpp"
#include "mpm_domain/lattice.hpp"

#include <array>
#include <cstdint>

namespace tremolo::mpm_domain {

/// The nodes and weights of four particles, a lane each: along x the four nodes around the particle's cell,
/// which all particles of the cell share; along y the three that its box touches. Lanes that are zero stand
/// for no particle.
struct Stencils {
  Lanes xi;     ///< cells above node 1 of a row
  Lanes eta;    ///< cells above row 0
  Lanes x0, y0; ///< column and row of the first node

  Stencils(const Lanes& x, const Lanes& y, const Axis& x_axis, const Axis& y_axis) {
    const Lanes column = x_axis.cells(x);
    const Lanes row = y_axis.cells(y);
    x0 = floor(column) - 1.0;
    y0 = floor(row - y_axis.l);
    xi = column - x0 - 1.0;
    eta = row - y0;
  }

  /// Lattice::index of the first node of each particle.
  std::array<std::int32_t, 4> first_nodes(const Lattice& lattice) const {
    const __m128i index =
        _mm256_cvttpd_epi32(y0 * static_cast<double>(lattice.nx) + x0 + static_cast<double>(lattice.first));
    std::array<std::int32_t, 4> first;
    _mm_storeu_si128(reinterpret_cast<__m128i*>(first.data()), index);
    return first;
  }
};

} // namespace tremolo::mpm_domain
