#include "plain_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::cost {

namespace {

/// uGIMP weights of the three nodes from `base` on, and their gradients.
struct Weights {
  int base;
  double s[3];
  double g[3];
};

/// @param place, half  particle and half its box, in cells from node 0
Weights weights(double position, double half, double h) {
  Weights w{static_cast<int>(position - half), {}, {}};
  const double before = w.base + 1 - (position - half); // the box's part before the second node, or all of it
  const double beyond = position + half - (w.base + 1);
  const double short_of = beyond < 0.0 ? -beyond : 0.0;
  const double past = beyond > 0.0 ? beyond : 0.0;
  const double box = 2.0 * half;
  w.s[0] = (before * before - short_of * short_of) / (2.0 * box);
  w.s[2] = past * past / (2.0 * box);
  w.s[1] = 1.0 - w.s[0] - w.s[2];
  w.g[0] = -(before - short_of) / (box * h);
  w.g[2] = past / (box * h);
  w.g[1] = -w.g[0] - w.g[2];
  return w;
}

} // namespace

PlainStep::PlainStep(int cells, double cell_size, double density, double young, double poisson)
    : nodes_(cells + 7), h_(cell_size), half_(0.25 * cell_size), origin_(-3.0 * cell_size),
      lame_(young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))),
      shear_(young / (2.0 * (1.0 + poisson))) {
  const double size = 0.5 * cell_size;
  for (int j = 0; j < 2 * cells; ++j)
    for (int i = 0; i < 2 * cells; ++i) {
      x_.push_back((i + 0.5) * size);
      y_.push_back((j + 0.5) * size);
      vx_.push_back(0.01 * std::sin(2.0 * std::numbers::pi * y_.back() / (cells * cell_size)));
    }
  vy_.resize(x_.size());
  for (auto* stress : {&sxx_, &syy_, &szz_, &sxy_})
    stress->resize(x_.size());
  volume_.assign(x_.size(), size * size);
  mass_.assign(x_.size(), density * size * size);
  const auto count = static_cast<std::size_t>(nodes_) * static_cast<std::size_t>(nodes_);
  for (auto* node :
       {&node_mass_, &node_px_, &node_py_, &node_fx_, &node_fy_, &node_vx_, &node_vy_, &node_ax_, &node_ay_})
    node->resize(count);
}

void PlainStep::step(double dt) {
  to_grid();
  move_nodes(dt);
  to_particles(dt);
}

double PlainStep::kinetic_energy() const {
  double energy = 0.0;
  for (std::size_t p = 0; p < x_.size(); ++p)
    energy += 0.5 * mass_[p] * (vx_[p] * vx_[p] + vy_[p] * vy_[p]);
  return energy;
}

void PlainStep::to_grid() {
  for (auto* node : {&node_mass_, &node_px_, &node_py_, &node_fx_, &node_fy_})
    std::fill(node->begin(), node->end(), 0.0);
  for (std::size_t p = 0; p < x_.size(); ++p) {
    const Weights wx = weights((x_[p] - origin_) / h_, half_ / h_, h_);
    const Weights wy = weights((y_[p] - origin_) / h_, half_ / h_, h_);
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<std::size_t>((wy.base + j) * nodes_ + wx.base + i);
        const double s = wx.s[i] * wy.s[j];
        const double gx = wx.g[i] * wy.s[j];
        const double gy = wx.s[i] * wy.g[j];
        node_mass_[n] += s * mass_[p];
        node_px_[n] += s * mass_[p] * vx_[p];
        node_py_[n] += s * mass_[p] * vy_[p];
        node_fx_[n] -= volume_[p] * (gx * sxx_[p] + gy * sxy_[p]);
        node_fy_[n] -= volume_[p] * (gx * sxy_[p] + gy * syy_[p]);
      }
  }
}

void PlainStep::move_nodes(double dt) {
  for (std::size_t n = 0; n < node_mass_.size(); ++n) {
    const double inverse = node_mass_[n] > 0.0 ? 1.0 / node_mass_[n] : 0.0;
    node_ax_[n] = node_fx_[n] * inverse;
    node_ay_[n] = node_fy_[n] * inverse;
    node_vx_[n] = node_px_[n] * inverse + dt * node_ax_[n];
    node_vy_[n] = node_py_[n] * inverse + dt * node_ay_[n];
  }
}

void PlainStep::to_particles(double dt) {
  for (std::size_t p = 0; p < x_.size(); ++p) {
    const Weights wx = weights((x_[p] - origin_) / h_, half_ / h_, h_);
    const Weights wy = weights((y_[p] - origin_) / h_, half_ / h_, h_);
    double vx = 0.0, vy = 0.0, ax = 0.0, ay = 0.0, lxx = 0.0, lxy = 0.0, lyx = 0.0, lyy = 0.0;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<std::size_t>((wy.base + j) * nodes_ + wx.base + i);
        const double s = wx.s[i] * wy.s[j];
        const double gx = wx.g[i] * wy.s[j];
        const double gy = wx.s[i] * wy.g[j];
        vx += s * node_vx_[n];
        vy += s * node_vy_[n];
        ax += s * node_ax_[n];
        ay += s * node_ay_[n];
        lxx += gx * node_vx_[n];
        lxy += gy * node_vx_[n];
        lyx += gx * node_vy_[n];
        lyy += gy * node_vy_[n];
      }
    vx_[p] += dt * ax;
    vy_[p] += dt * ay;
    x_[p] += dt * vx;
    y_[p] += dt * vy;
    const double turn = 0.5 * dt * (lyx - lxy);
    const double difference = sxx_[p] - syy_[p];
    const double carried_xy = sxy_[p] + turn * difference;
    const double carried = 2.0 * turn * sxy_[p];
    const double volumetric = lame_ * dt * (lxx + lyy);
    sxx_[p] += volumetric + 2.0 * shear_ * dt * lxx - carried;
    syy_[p] += volumetric + 2.0 * shear_ * dt * lyy + carried;
    szz_[p] += volumetric;
    sxy_[p] = carried_xy + shear_ * dt * (lxy + lyx);
    volume_[p] *= 1.0 + dt * (lxx + lyy);
  }
}

} // namespace tremolo::cost
