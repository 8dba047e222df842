// v = (G - m_f w)/m and w = (R - m~_f G/m)/(m~_f m_s/m + kappa d), or with grains held w = (R - m~_f v)/(m~_f
// + kappa d), as v = own G + other R, w = own R + other G in each direction.

#include "freefield/marched/node_split.hpp"

#include <iterator>

namespace tremolo::freefield {

void NodeMasses::gather(const std::vector<WetNode>& nodes) {
  for (Eigen::ArrayXd* values : {&solid, &fluid, &full, &drag, &passes, &mass_damping})
    values->resize(std::ssize(nodes));
  for (Eigen::Index i = 0; const WetNode& node : nodes) {
    solid[i] = node.solid;
    fluid[i] = node.fluid;
    full[i] = node.full;
    drag[i] = node.drag;
    passes[i] = node.sealed ? 0.0 : 1.0;
    mass_damping[i] = node.mass_damping;
    ++i;
  }
  mass = solid + fluid;
}

void NodeSplit::set(const NodeMasses& nodes, double drag_time, double brake_time, bool base_held) {
  own_.resize(nodes.mass.size(), 4);
  other_.resize(nodes.mass.size(), 4);
  per_mass_ = 1.0 / (nodes.mass + brake_time * nodes.mass_damping);
  share_ = nodes.fluid / nodes.mass;
  mobility_ = nodes.full * (1.0 - share_) + drag_time * nodes.drag;
  per_mass_[0] = 1.0 / nodes.mass[0];
  if (base_held) {
    per_mass_[0] = 1.0;
    share_[0] = 0.0;
    mobility_[0] = nodes.full[0] + drag_time * nodes.drag[0];
  }
  mobility_ = (nodes.fluid > 0.0).select(1.0 / mobility_, 0.0);
  own_.col(2) = mobility_;
  own_.col(3) = mobility_ * nodes.passes;
  for (const Eigen::Index c : {0, 1}) {
    own_.col(c) = per_mass_ * (1.0 + share_ * own_.col(c + 2) * nodes.full);
    other_.col(c) = -share_ * own_.col(c + 2);
    other_.col(c + 2) = -own_.col(c + 2) * nodes.full * per_mass_;
  }
}

void NodeSplit::operator()(const NodeFields& momenta, NodeFields& velocity) const {
  velocity.leftCols<2>() =
      own_.leftCols<2>() * momenta.leftCols<2>() + other_.leftCols<2>() * momenta.rightCols<2>();
  velocity.rightCols<2>() =
      own_.rightCols<2>() * momenta.rightCols<2>() + other_.rightCols<2>() * momenta.leftCols<2>();
}

Eigen::Vector4d NodeSplit::at(std::size_t node, const Eigen::Vector4d& momenta) const {
  const auto i = static_cast<Eigen::Index>(node);
  const Eigen::Vector4d swapped(momenta[2], momenta[3], momenta[0], momenta[1]);
  return own_.row(i).matrix().transpose().cwiseProduct(momenta) +
         other_.row(i).matrix().transpose().cwiseProduct(swapped);
}

} // namespace tremolo::freefield
