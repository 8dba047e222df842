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

void BandMatrix::solve(std::span<double> x) const {
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = first(i); j < i; ++j)
      x[i] -= at(i, j) * x[j];
    x[i] /= at(i, i);
  }
  for (std::size_t i = size_; i-- > 0;) {
    x[i] /= at(i, i);
    for (std::size_t j = first(i); j < i; ++j)
      x[j] -= at(i, j) * x[i];
  }
}

} // namespace tremolo::mpm_domain
