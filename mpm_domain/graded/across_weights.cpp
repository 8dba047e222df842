#include "mpm_domain/graded/across_weights.hpp"

#include <cmath>

namespace tremolo::mpm_domain {

namespace {

/// Replaces the entries of tied nodes by those of the nodes that they follow, P^T.
void resolve(const Prolongation& prolongation, std::vector<BoxWeight>& weights, std::size_t first) {
  const std::size_t end = weights.size();
  for (std::size_t n = first; n < end; ++n) {
    const std::span<const Share> shares = prolongation.shares_of(weights[n].node);
    if (shares.empty())
      continue;
    const BoxWeight tied = weights[n];
    const auto part = [&](const Share& share) {
      return BoxWeight{share.node,
                       tied.x + share.dx,
                       tied.y + share.dy,
                       tied.s * share.weight,
                       tied.gx * share.weight,
                       tied.gy * share.weight};
    };
    weights[n] = part(shares.front());
    for (const Share& share : shares.subspan(1))
      weights.push_back(part(share));
  }
}

/// Adds up the entries of one node from `first` on, but of none of its images, which lie a period >= h apart.
/// Lists are short.
void merge(std::vector<BoxWeight>& weights, std::size_t first, double h) {
  std::size_t end = first;
  for (std::size_t n = first; n < weights.size(); ++n) {
    const BoxWeight w = weights[n];
    std::size_t m = first;
    while (m < end && (weights[m].node != w.node || std::abs(weights[m].x - w.x) > 0.5 * h))
      ++m;
    if (m == end) {
      weights[end++] = w;
      continue;
    }
    weights[m].s += w.s;
    weights[m].gx += w.gx;
    weights[m].gy += w.gy;
  }
  weights.resize(end);
}

} // namespace

void AcrossWeights::restart(std::size_t first) {
  first_ = first;
  start_.assign(1, 0);
  weights_.clear();
}

void AcrossWeights::add(const GradedMesh& mesh, const mesh::Rectangle& box) {
  box_average(mesh, box, weights_);
  resolve(mesh.prolongation(), weights_, start_.back());
  merge(weights_, start_.back(), mesh.tree().roots().h);
  start_.push_back(weights_.size());
}

} // namespace tremolo::mpm_domain
