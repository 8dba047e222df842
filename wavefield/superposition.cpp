#include "wavefield/superposition.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <utility>

namespace tremolo::wavefield {

void add(History& sum, const History& other) {
  using Series = std::vector<double> History::*;
  for (const Series series :
       {&History::ux, &History::uy, &History::vx, &History::vy, &History::sxx, &History::syy, &History::sxy,
        &History::exx, &History::eyy, &History::gxy, &History::vx_rate, &History::vy_rate, &History::sxx_rate,
        &History::syy_rate, &History::sxy_rate})
    std::ranges::transform(sum.*series, other.*series, (sum.*series).begin(), std::plus<>());
}

Superposition::Superposition(std::vector<LayeredField> waves) : waves_(std::move(waves)) {
  if (waves_.empty())
    throw std::invalid_argument("a superposition of no waves");
}

std::vector<History> Superposition::sample(std::span<const Point> points, const TimeGrid& grid, Part part,
                                           const Quantities& quantities) const {
  std::vector<History> sums = waves_.front().sample(points, grid, part, quantities);
  for (const LayeredField& wave : std::span(waves_).subspan(1)) {
    const std::vector<History> more = wave.sample(points, grid, part, quantities);
    for (std::size_t i = 0; i < sums.size(); ++i)
      add(sums[i], more[i]);
  }
  return sums;
}

} // namespace tremolo::wavefield
