#include "mpm_domain/boundary/closing/closing_elements.hpp"

#include "tests/support/box_run.hpp"
#include "tests/support/support_by_hand.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using Complex = std::complex<double>;
using Elements = test_support::SupportByHand<ClosingElements>;

/// Traction over velocity of an element whose face moves as cos(w t), at frequency w (1/s): that of the
/// spring from what the element tells, that of the mass added.
Complex impedance(const Spec& spec, std::size_t face, double w) {
  Elements elements(spec);
  const std::size_t faces = elements.faces().size();
  const double dt = 1e-3 / w;
  std::vector<eq6::FreeField> still(faces);
  std::vector<Vector> v(faces);
  Complex spring;
  const int warm_up = 40000;
  const int period = static_cast<int>(std::lround(2.0 * 3.14159265358979 / (w * dt)));
  for (int step = 0; step < warm_up + period; ++step) {
    const double time = step * dt;
    v[face] = {std::cos(w * (time - 0.5 * dt)), 0.0};
    const auto loads = elements.move(time, v, still);
    if (step >= warm_up)
      spring += 2.0 / period * loads[face].own.x * std::exp(Complex(0.0, -w * time));
  }
  return -spring + Complex(0.0, w) * elements.faces()[face].behind.moving_mass.x;
}

TEST(ClosingElements, HaveTheImpedanceOfMassSpringAndDashpot) {
  Spec spec = test_support::elastic_box(8.0, 6.0, 0.5);
  spec.scheme.dispersion = Dispersion::reduced;
  const BoundaryFace face = Elements(spec).faces().front(); // of the left side: x is normal
  const double c = materials::elasticity(spec.soils.front().law).p_wave_speed();
  for (const double kh : {0.2, 0.6}) {
    const double w = kh * c / spec.cell_size;
    const Complex s(0.0, kh);
    const double b = std::sqrt(0.2);
    const Complex exact = face.ground.impedance_p * (b * s + 1.0 / (1.0 + b * s));
    EXPECT_LT(std::abs(impedance(spec, 0, w) - exact), 2e-3 * std::abs(exact));
  }
}

/// A free field that comes in through the base pulls at a still soil as with dashpots, twice its traction;
/// one that goes out does not pull at all.
TEST(ClosingElements, WhatGoesOutThroughTheBaseDoesNotPull) {
  Spec spec = test_support::elastic_box(8.0, 6.0, 0.5);
  spec.scheme.dispersion = Dispersion::reduced;
  Elements elements(spec);
  const auto faces = elements.faces();
  std::size_t base = 0;
  while (faces[base].side != Side::base)
    ++base;
  const double z = faces[base].ground.impedance_s;
  for (const double way : {1.0, -1.0}) { // up, down
    Elements anew(spec);
    const std::vector<Vector> still(faces.size());
    std::vector<eq6::FreeField> field(faces.size());
    field[base] = {{0.1, 0.0}, {0.0, 0.0, -way * z * 0.1}};
    const auto loads = anew.move(0.0, still, field);
    const double traction = -field[base].stress.xy; // on the base, whose normal points down
    EXPECT_NEAR(loads[base].driven.x + traction, way > 0.0 ? 2.0 * z * 0.1 : 0.0, 1e-9 * z);
  }
}

} // namespace
} // namespace tremolo::mpm_domain
