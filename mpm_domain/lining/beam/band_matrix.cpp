#include "mpm_domain/lining/beam/band_matrix.hpp"

#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

void BandMatrix::factorise() {
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = first(i); j <= i; ++j) {
      double rest = at(i, j);
      for (std::size_t k = std::max(first(i), first(j)); k < j; ++k)
        rest -= at(i, k) * at(j, k);
      if (j < i)
        at(i, j) = rest / at(j, j);
      else if (rest > 0.0)
        at(i, i) = std::sqrt(rest);
      else
        throw std::runtime_error("a beam has no inertia in one of its directions, so that its motion is not "
                                 "determined");
    }
  }
}

void BandMatrix::solve(std::span<double> x, std::size_t columns) const {
  const auto subtract = [&](std::size_t from, double factor, std::size_t row) {
    for (std::size_t c = 0; c < columns; ++c)
      x[from * columns + c] -= factor * x[row * columns + c];
  };
  const auto divide = [&](std::size_t row) {
    for (std::size_t c = 0; c < columns; ++c)
      x[row * columns + c] /= at(row, row);
  };
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = first(i); j < i; ++j)
      subtract(i, at(i, j), j);
    divide(i);
  }
  for (std::size_t i = size_; i-- > 0;) {
    divide(i);
    for (std::size_t j = first(i); j < i; ++j)
      subtract(j, at(i, j), i);
  }
}

} // namespace tremolo::mpm_domain
