#include "materials/driver.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace tremolo::materials {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// What one component still lacks, as a strain: stresses are divided by the modulus.
double missing(const Control& control, double strain_increment, double stress, double modulus) {
  return control.by_stress() ? (stress - control.value()) / modulus : strain_increment - control.value();
}

Vector3d missing(const PointStep& step, const Vector3d& strain, const PointStress& stress, double modulus) {
  return {missing(step.xx, strain[0], stress.xx, modulus), missing(step.yy, strain[1], stress.yy, modulus),
          missing(step.xy, strain[2], stress.xy, modulus)};
}

/// The increments that are prescribed, zero where the stress is.
Vector3d first_guess(const PointStep& step) {
  const auto guess = [](const Control& control) { return control.by_stress() ? 0.0 : control.value(); };
  return {guess(step.xx), guess(step.yy), guess(step.xy)};
}

} // namespace

PointTest::PointTest(const Law& law, const PointStress& initial) : law_(law), stress_(initial) {
  validate(law_);
  state_.resize(state_variables(law_).size());
  const PointStrain none;
  const double still = 0.0;
  initialise(law_, view(none, still));
}

Points PointTest::view(const PointStrain& increment, const double& rotation) {
  Points points;
  points.count = 1;
  points.sxx = &stress_.xx;
  points.syy = &stress_.yy;
  points.szz = &stress_.zz;
  points.sxy = &stress_.xy;
  points.state = state_.data();
  points.plastic_work = &plastic_work_;
  points.dexx = &increment.xx;
  points.deyy = &increment.yy;
  points.dgxy = &increment.xy;
  points.dwxy = &rotation;
  return points;
}

PointTest PointTest::after(const PointStrain& increment, double rotation) const {
  PointTest next = *this;
  update(law_, next.view(increment, rotation));
  next.strain_ = {strain_.xx + increment.xx, strain_.yy + increment.yy, strain_.xy + increment.xy};
  return next;
}

void PointTest::apply(const PointStep& step) {
  const double modulus = elasticity(law_).p_modulus();
  const auto taken = [&](const Vector3d& x) { return after({x[0], x[1], x[2]}, step.rotation); };
  const auto residual = [&](const Vector3d& x, const PointTest& end) {
    return missing(step, x, end.stress_, modulus);
  };
  constexpr double perturbation = 1e-9; // strain
  constexpr double tolerance = 1e-14;   // strain: 1e-6 Pa in a soil of 100 MPa
  constexpr int most_iterations = 50;

  Vector3d x = first_guess(step);
  PointTest end = taken(x);
  Vector3d r = residual(x, end);
  for (int iteration = 0; !(r.lpNorm<Eigen::Infinity>() <= tolerance); ++iteration) {
    if (iteration == most_iterations) {
      throw std::runtime_error(
          fmt::format("no strain gives the prescribed stress: {:.3g} Pa is missing after {} "
                      "iterations; the point may have passed its peak load",
                      modulus * r.lpNorm<Eigen::Infinity>(), most_iterations));
    }
    Matrix3d tangent;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Vector3d moved = x + perturbation * Vector3d::Unit(k);
      tangent.col(k) = (residual(moved, taken(moved)) - r) / perturbation;
    }
    x -= tangent.fullPivLu().solve(r);
    end = taken(x);
    r = residual(x, end);
  }
  *this = std::move(end);
}

} // namespace tremolo::materials
