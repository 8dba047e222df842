#include "mpm_domain/lining/beam/band_matrix.hpp"

#include "base/lanes.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

std::vector<std::size_t> numbers_of_ring(std::size_t count) {
  std::vector<std::size_t> order;
  order.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t half = (k + 1) / 2;
    order.push_back(k % 2 == 0 ? half : count - half);
  }
  return order;
}

void BandMatrix::factorise() {
  std::vector<double> column(width_ + lanes, 0.0); // D_k L_ik
  for (std::size_t k = 0; k < size_; ++k) {
    if (!(at(k, k) > 0.0))
      throw std::runtime_error("a beam has no inertia in one of its directions, so that its motion is not "
                               "determined");
    inverse_[k] = 1.0 / at(k, k);
    const std::size_t below = std::min(size_, k + width_ + 1) - k - 1;
    for (std::size_t i = 0; i < below; ++i)
      column[i] = at(k + 1 + i, k);
    for (std::size_t i = 0; i < below; ++i) {
      const double factor = column[i] * inverse_[k];
      at(k + 1 + i, k) = factor;
      double* const row = &at(k + 1 + i, k + 1);
      for (std::size_t j = 0; j <= i; j += lanes) // what lies behind the diagonal is not read
        store(row + j, load(row + j) - factor * load(&column[j]));
    }
  }
}

/// X = L^-T D^-1 L^-1 X for as many columns as stay in registers, as groups that stand side by side in x.
template <class Group, class InMemory, std::size_t Count>
void BandMatrix::solve_groups(double* x, std::size_t stride) const {
  constexpr std::size_t width = sizeof(Group) / sizeof(double);
  std::array<Group, Count> left;
  const auto entry = [&](std::size_t row, std::size_t group) {
    return reinterpret_cast<InMemory*>(x + row * stride + group * width);
  };
  const auto begin = [&](double factor, std::size_t row) {
#pragma GCC unroll 8
    for (std::size_t g = 0; g < Count; ++g)
      left[g] = factor * *entry(row, g);
  };
  const auto subtract = [&](double factor, std::size_t row) {
#pragma GCC unroll 8
    for (std::size_t g = 0; g < Count; ++g)
      left[g] -= factor * *entry(row, g);
  };
  const auto end = [&](std::size_t row) {
#pragma GCC unroll 8
    for (std::size_t g = 0; g < Count; ++g)
      *entry(row, g) = left[g];
  };
  for (std::size_t i = 0; i < size_; ++i) {
    begin(1.0, i);
    for (std::size_t j = first(i); j < i; ++j)
      subtract(at(i, j), j);
    end(i);
  }
  for (std::size_t i = size_; i-- > 0;) {
    begin(inverse_[i], i);
    for (std::size_t j = std::min(size_, i + width_ + 1); --j > i;)
      subtract(at(j, i), j);
    end(i);
  }
}

void BandMatrix::solve(std::span<double> x, std::size_t columns) const {
  std::size_t c = 0;
  for (; c + 16 <= columns; c += 16)
    solve_groups<Lanes, LanesInMemory, 4>(x.data() + c, columns);
  for (; c + 4 <= columns; c += 4)
    solve_groups<Lanes, LanesInMemory, 1>(x.data() + c, columns);
  for (; c < columns; ++c)
    solve_groups<double, double, 1>(x.data() + c, columns);
}

} // namespace tremolo::mpm_domain
