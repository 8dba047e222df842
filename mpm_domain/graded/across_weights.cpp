#include "mpm_domain/graded/across_weights.hpp"

namespace tremolo::mpm_domain {

namespace {

/// Adds up the entries of one node from `first` on; lists are short.
void merge(std::vector<BoxWeight>& weights, std::size_t first) {
  std::size_t end = first;
  for (std::size_t n = first; n < weights.size(); ++n) {
    const BoxWeight w = weights[n];
    std::size_t m = first;
    while (m < end && weights[m].node != w.node)
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
  merge(weights_, start_.back());
  start_.push_back(weights_.size());
}

} // namespace tremolo::mpm_domain
