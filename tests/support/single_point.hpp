#pragma once

#include "materials/driver.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace tremolo::materials::test {

/// Strain increment of a step, out-of-plane component included; shear strain is the engineering one.
struct Strain3 {
  double xx = 0.0;
  double yy = 0.0;
  double zz = 0.0;
  double xy = 0.0;
};

/// One point driven by strain in all four components.
struct SinglePoint {
  Law law;
  PointStress stress;
  std::vector<double> state = std::vector<double>(state_variables(law).size());
  double plastic_work = 0.0;

  SinglePoint(Law of, const PointStress& initial) : law(std::move(of)), stress(initial) {
    const Strain3 none;
    const double still = 0.0;
    initialise(law, view(none, still));
  }

  void move(const Strain3& increment, double rotation = 0.0) { update(law, view(increment, rotation)); }

  Points view(const Strain3& increment, const double& rotation) {
    return {.count = 1,
            .sxx = &stress.xx,
            .syy = &stress.yy,
            .szz = &stress.zz,
            .sxy = &stress.xy,
            .state = state.data(),
            .plastic_work = &plastic_work,
            .dexx = &increment.xx,
            .deyy = &increment.yy,
            .dgxy = &increment.xy,
            .dwxy = &rotation,
            .dezz = &increment.zz};
  }
};

/// One step of the triaxial test: axial strain along y, the same lateral strain along x and z such that
/// s_xx = s_zz comes to `lateral` (Pa). By secants, from the elastic guess.
inline void triaxial_step(SinglePoint& point, double axial, double lateral) {
  const Elasticity& elastic = elasticity(point.law);
  const auto after = [&](double strain) {
    SinglePoint next = point;
    next.move({strain, axial, strain, 0.0});
    return next;
  };
  double a = -elastic.poisson * axial;
  double fa = after(a).stress.xx - lateral;
  double b = a - 0.5 * fa / elastic.p_modulus();
  for (int k = 0; k < 60 && std::abs(fa) > 1e-7; ++k) {
    const double fb = after(b).stress.xx - lateral;
    const double next = fb == fa ? b : b - fb * (b - a) / (fb - fa);
    a = b;
    fa = fb;
    b = next;
  }
  point.move({a, axial, a, 0.0});
}

} // namespace tremolo::materials::test
