#include "freefield/fe/fe_newton.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::freefield {
namespace {

constexpr int most_iterations_consistent = 25;
constexpr int most_iterations_initial = 500;

/// What rounding of the soil's total stresses leaves in a residual, relative to them.
constexpr double stress_rounding = 1e-13;

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values)
    most = std::max(most, std::abs(value));
  return most;
}

Eigen::Matrix2d matrix(const Stiffness& d) {
  return (Eigen::Matrix2d() << d[0], d[1], d[2], d[3]).finished();
}

} // namespace

void hold_base(const FeElements& elements, FeMotion& motion) {
  if (elements.prescribed() == 0)
    return;
  const BaseComponent* components[] = {&motion.base.x, &motion.base.y};
  for (std::size_t i = 0; i < 2; ++i) {
    motion.u[i] = components[i]->displacement;
    motion.v[i] = components[i]->velocity;
    motion.a[i] = components[i]->acceleration;
  }
}

FeNewton::FeNewton(double hht_alpha, Tangent tangent, double tolerance)
    : hht_(HhtParameters::from_alpha(hht_alpha)), tangent_(tangent), tolerance_(tolerance) {}

/// g(a') at the iterate `end`, and its largest entry; 0 where the motion is prescribed.
double FeNewton::residual(const FeElements& elements, const FeState& begin, const FeState& end,
                          std::vector<double>& g) {
  std::size_t worst = 0;
  for (std::size_t i = 0; i < g.size(); ++i) {
    g[i] = i < elements.prescribed()
               ? 0.0
               : elements.mass()[i] * end.a[i] + (1.0 + hht_.alpha) * end.r[i] - hht_.alpha * begin.r[i];
    if (!std::isnan(g[worst]) && !(std::abs(g[i]) <= std::abs(g[worst]))) // the first NaN is the worst
      worst = i;
  }
  worst_element_ = worst < 2 ? 0 : worst / 2 - 1;
  return std::abs(g[worst]);
}

BlockTridiagonal<2> FeNewton::jacobian(const FeElements& elements, double dt,
                                       const std::vector<Stiffness>& soil,
                                       const std::vector<Stiffness>& initial) const {
  const std::size_t nodes = elements.freedoms() / 2;
  const double weight = 1.0 + hht_.alpha;
  BlockTridiagonal<2> j(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    const auto entry = [&](std::size_t f) {
      return elements.mass()[f] + weight * hht_.gamma * dt * elements.dashpots()[f];
    };
    j.diagonal(i) = Eigen::Vector2d(entry(2 * i), entry(2 * i + 1)).asDiagonal();
  }
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const double scale = weight / elements[e].length;
    const Eigen::Matrix2d k = scale * (hht_.beta * dt * dt * matrix(soil[e]) +
                                       hht_.gamma * dt * elements[e].damping_time * matrix(initial[e]));
    j.diagonal(e) += k;
    j.diagonal(e + 1) += k;
    j.lower(e) = j.upper(e) = -k;
  }
  if (elements.prescribed() > 0) {
    j.diagonal(0).setIdentity();
    j.upper(0).setZero();
  }
  j.factor();
  return j;
}

bool FeNewton::step(const FeElements& elements, const FeSoil& soil, const FeState& begin, double dt,
                    double traction_scale, FeState& end) {
  const auto [alpha, beta, gamma] = hht_;
  const std::size_t n = elements.freedoms();
  std::vector<double> du(n), g(n), deyy(elements.count()), dgxy(elements.count());
  std::vector<Stiffness> stiffness;
  const int most = tangent_ == Tangent::consistent ? most_iterations_consistent : most_iterations_initial;
  end.a = begin.a;
  for (int iteration = 0;; ++iteration) {
    for (std::size_t i = 0; i < n; ++i) {
      du[i] = dt * begin.v[i] + dt * dt * ((0.5 - beta) * begin.a[i] + beta * end.a[i]);
      end.u[i] = begin.u[i] + du[i];
      end.v[i] = begin.v[i] + dt * ((1.0 - gamma) * begin.a[i] + gamma * end.a[i]);
    }
    hold_base(elements, end);
    for (std::size_t i = 0; i < elements.prescribed(); ++i)
      du[i] = end.u[i] - begin.u[i];
    elements.strains(du, deyy, dgxy);
    end.soil = begin.soil;
    soil.update(end.soil, deyy, dgxy);
    elements.resistance(soil, end.soil, end.v, end.v, end.base, end.r);
    const double error = residual(elements, begin, end, g);
    if (!std::isfinite(error))
      return false;
    const double scale = std::max(traction_scale, largest(end.r));
    const double rounding = stress_rounding * std::max(largest(end.soil.syy), largest(end.soil.sxy));
    if (error <= tolerance_ * scale + rounding) {
      end.stress_velocity = end.v;
      return true;
    }
    if (iteration == most)
      return false;
    ++iterations_;
    if (tangent_ == Tangent::consistent) {
      soil.tangents(begin.soil, end.soil, deyy, dgxy, stiffness);
      jacobian(elements, dt, stiffness, soil.initial_stiffness()).solve(g.data());
    } else {
      if (!initial_ || initial_->dt != dt)
        initial_ = Factored{dt, jacobian(elements, dt, soil.initial_stiffness(), soil.initial_stiffness())};
      initial_->matrix.solve(g.data());
    }
    for (std::size_t i = 0; i < n; ++i)
      end.a[i] -= g[i];
  }
}

} // namespace tremolo::freefield
