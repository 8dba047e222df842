#include "mpm_domain/lining/segment_soil.hpp"

#include "mpm_domain/lining/beam/band_matrix.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

namespace tremolo::mpm_domain {

namespace {

/// Two segments that soil reaches at one node alone have the same rows, and bear the same.
constexpr double alike = 1e-12;

/// The part of an entry of B m^-1 B^T that does not depend on directions.
struct Tensor {
  double xx = 0.0, yx = 0.0, xy = 0.0, yy = 0.0;

  double between(const Vector& a, const Vector& b) const {
    return a.x * (xx * b.x + xy * b.y) + a.y * (yx * b.x + yy * b.y);
  }
};

/// The end of the members of the node that one of them has.
template <class Iterator>
Iterator end_of_node(Iterator first, Iterator last) {
  return std::find_if(first, last, [&](const auto& of) { return of.node != first->node; });
}

} // namespace

void SegmentSoil::take_members(std::span<const SegmentRows> rows) {
  std::size_t least = std::numeric_limits<std::size_t>::max();
  std::size_t most = 0;
  for (const SegmentRows& of : rows)
    for (const NodeShare& at : of.soil) {
      least = std::min(least, at.node);
      most = std::max(most, at.node);
    }
  // Counted node by node, which is cheaper than to sort them.
  std::vector<std::uint32_t> position(most < least ? 0 : most - least + 1, 0);
  std::size_t count = 0;
  for (const SegmentRows& of : rows)
    for (const NodeShare& at : of.soil) {
      ++position[at.node - least];
      ++count;
    }
  std::exclusive_scan(position.begin(), position.end(), position.begin(), std::uint32_t{0});
  members_.resize(count);
  for (std::size_t row = 0; row < rows_; ++row)
    for (const auto& [node, share] : rows[row].soil)
      members_[position[node - least]++] = {node, row, share};
}

SegmentSoil::SegmentSoil(std::span<const SegmentRows> rows, const SoilMotion& soil) : rows_(rows.size()) {
  take_members(rows);
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> block_of(rows_ * rows_, none);
  std::vector<Tensor> tensors;
  for (auto first = members_.cbegin(); first != members_.cend();) {
    const auto end = end_of_node(first, members_.cend());
    const Vector x = soil.of_grains(first->node, {1.0, 0.0});
    const Vector y = soil.of_grains(first->node, {0.0, 1.0});
    for (auto a = first; a != end; ++a)
      for (auto b = first; b <= a; ++b) {
        std::uint32_t& block = block_of[a->row * rows_ + b->row];
        if (block == none) {
          block = static_cast<std::uint32_t>(tensors.size());
          tensors.emplace_back();
          blocks_.push_back({a->row, b->row, {}});
        }
        const double share = a->share * b->share;
        Tensor& to = tensors[block];
        to = {to.xx + share * x.x, to.yx + share * x.y, to.xy + share * y.x, to.yy + share * y.y};
      }
    first = end;
  }
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    const SegmentRows& a = rows[blocks_[k].a];
    const SegmentRows& b = rows[blocks_[k].b];
    blocks_[k].answer = {tensors[k].between(a.normal, b.normal), tensors[k].between(a.normal, b.tangent()),
                         tensors[k].between(a.tangent(), b.normal),
                         tensors[k].between(a.tangent(), b.tangent())};
  }
}

void SegmentSoil::add_answer(std::span<double> to) const {
  const std::size_t size = 2 * rows_;
  for (const auto& [a, b, answer] : blocks_)
    for (const std::size_t i : {0U, 1U})
      for (const std::size_t j : {0U, 1U}) {
        to[(2 * a + i) * size + 2 * b + j] += answer[2 * i + j];
        if (a != b)
          to[(2 * b + j) * size + 2 * a + i] += answer[2 * i + j];
      }
}

std::vector<NodeChange> SegmentSoil::changes(std::span<const Vector> impulses, const SoilMotion& soil) const {
  std::vector<NodeChange> changes;
  changes.reserve(members_.size());
  for (auto first = members_.cbegin(); first != members_.cend();) {
    const auto end = end_of_node(first, members_.cend());
    Vector impulse{};
    for (auto of = first; of != end; ++of)
      impulse = impulse - of->share * impulses[of->row];
    const NodeFlow* flow = soil.flow(first->node);
    const Vector change = soil.of_grains(first->node, impulse);
    changes.push_back({first->node, change, flow != nullptr ? flow->of_water(impulse) : change});
    first = end;
  }
  return changes;
}

std::vector<double> SegmentSoil::stop(std::span<const double> closing,
                                      const std::vector<bool>& stopped) const {
  std::vector<std::size_t> number(2 * rows_); // in the band
  std::size_t count = 0;
  for (const std::size_t segment : numbers_of_ring(rows_))
    for (const std::size_t row : {2 * segment, 2 * segment + 1})
      if (stopped[row])
        number[row] = count++;
  const auto for_entries = [&](const auto& act) {
    for (const auto& [a, b, answer] : blocks_)
      for (const std::size_t i : {0U, 1U})
        for (const std::size_t j : {0U, 1U})
          if (const std::size_t r = 2 * a + i, c = 2 * b + j; c <= r && stopped[r] && stopped[c])
            act(std::max(number[r], number[c]), std::min(number[r], number[c]), answer[2 * i + j]);
  };
  std::size_t width = 0;
  for_entries([&](std::size_t r, std::size_t c, double) { width = std::max(width, r - c); });
  BandMatrix matrix(count, width);
  for_entries([&](std::size_t r, std::size_t c, double answer) {
    matrix.add(r, c, r == c ? (1.0 + alike) * answer : answer);
  });
  matrix.factorise();
  std::vector<double> found(count);
  for (std::size_t row = 0; row < stopped.size(); ++row)
    if (stopped[row])
      found[number[row]] = closing[row];
  matrix.solve(found);
  std::vector<double> impulses(2 * rows_, 0.0);
  for (std::size_t row = 0; row < stopped.size(); ++row)
    if (stopped[row])
      impulses[row] = found[number[row]];
  return impulses;
}

} // namespace tremolo::mpm_domain
