#include "mpm_domain/lining/water/segment_water.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// A segment is wet where its wet nodes have this part of it, at least.
constexpr double least_wet = 0.5;

struct WetShare {
  const WetNode* at;
  double share;
};

/// The wet nodes of a segment, their shares made up to one; none: it is dry.
std::vector<WetShare> wet_shares(const SegmentRows& rows, std::span<const WetNode> nodes) {
  std::vector<WetShare> shares;
  double sum = 0.0;
  for (const auto& [node, share] : rows.soil) {
    const auto found = std::ranges::lower_bound(nodes, node, {}, &WetNode::node);
    if (found == nodes.end() || found->node != node)
      continue;
    shares.push_back({&*found, share});
    sum += share;
  }
  if (sum < least_wet)
    return {};
  for (WetShare& of_node : shares)
    of_node.share /= sum;
  return shares;
}

/// An entry of B_n m~_f^-1 B_n^T.
double answer_between(std::span<const WetShare> a, std::span<const WetShare> b) {
  double sum = 0.0;
  for (const WetShare& of_a : a)
    for (const WetShare& of_b : b)
      if (of_a.at == of_b.at)
        sum += of_a.share * of_b.share / of_a.at->mass;
  return sum;
}

} // namespace

SegmentWater find_segment_water(std::span<const SegmentRows> rows, std::span<const WetNode> nodes,
                                std::span<const double> beam_answer, std::span<const double> v) {
  const std::size_t size = 2 * rows.size();
  SegmentWater water{std::vector<bool>(rows.size(), false), std::vector<double>(rows.size(), 0.0), {}};
  std::vector<std::pair<std::size_t, std::vector<WetShare>>> wet;
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (std::vector<WetShare> shares = wet_shares(rows[row], nodes); !shares.empty()) {
      water.wet[row] = true;
      wet.emplace_back(row, std::move(shares));
    }
  if (wet.empty())
    return water;
  const auto count = static_cast<Eigen::Index>(wet.size());
  Eigen::MatrixXd of_water(count, count); // its lower half
  Eigen::MatrixXd right(count, static_cast<Eigen::Index>(size) + 1);
  for (Eigen::Index a = 0; a < count; ++a) {
    const auto& [row, shares] = wet[static_cast<std::size_t>(a)];
    const Vector& n = rows[row].normal;
    for (Eigen::Index b = 0; b <= a; ++b) {
      const auto& [other, of_other] = wet[static_cast<std::size_t>(b)];
      of_water(a, b) = dot(n, rows[other].normal) * answer_between(shares, of_other);
    }
    Vector speed = beam_velocity(rows[row], v);
    speed = {-speed.x, -speed.y};
    for (const WetShare& of_node : shares)
      speed = {speed.x + of_node.share * of_node.at->velocity.x,
               speed.y + of_node.share * of_node.at->velocity.y};
    right(a, 0) = dot(n, speed);
    for (std::size_t c = 0; c < size; ++c)
      right(a, static_cast<Eigen::Index>(c) + 1) = beam_answer[2 * row * size + c];
  }
  const Eigen::MatrixXd found = of_water.selfadjointView<Eigen::Lower>().llt().solve(right);
  water.answer.assign(rows.size() * size, 0.0);
  for (Eigen::Index a = 0; a < count; ++a) {
    const std::size_t row = wet[static_cast<std::size_t>(a)].first;
    water.alone[row] = found(a, 0);
    for (std::size_t c = 0; c < size; ++c)
      water.answer[row * size + c] = found(a, static_cast<Eigen::Index>(c) + 1);
  }
  return water;
}

} // namespace tremolo::mpm_domain
