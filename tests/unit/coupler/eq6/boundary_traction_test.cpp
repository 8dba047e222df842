// Eq. (6) in its three parts.

#include "coupler/eq6/boundary_traction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::eq6 {
namespace {

constexpr double tolerance = 1e-14; // relative

void expect_near(Vector found, Vector expected, double scale) {
  EXPECT_NEAR(found.x, expected.x, tolerance * scale);
  EXPECT_NEAR(found.y, expected.y, tolerance * scale);
}

const Vector v_domain{0.3, -0.1};
const FreeField field{{0.1, 0.25}, {-2e4, 5e3, 7e3}};
const Vector held{-1.5e5, 2e4};

/// Faces that look in all directions.
class BoundaryTraction : public testing::TestWithParam<double> {
protected:
  double angle_ = GetParam() * std::numbers::pi / 180.0;
  Face face_{{std::cos(angle_), std::sin(angle_)}, 3e5, 1.6e5};
};

/// -(rho c_p n n^T + rho c_s t t^T) (v^m - v^ff), sigma n, and what holds at rest, component by component.
TEST_P(BoundaryTraction, HasTheClosedFormsOfItsParts) {
  const double c = face_.normal.x, s = face_.normal.y;
  const double p = face_.impedance_p, q = face_.impedance_s;
  const double dx = v_domain.x - field.velocity.x, dy = v_domain.y - field.velocity.y;
  const Traction found = boundary_traction(face_, v_domain, field, held);
  expect_near(found.viscous,
              {-((p * c * c + q * s * s) * dx + (p - q) * c * s * dy),
               -((p - q) * c * s * dx + (p * s * s + q * c * c) * dy)},
              p);
  const auto& [xx, yy, xy] = field.stress;
  expect_near(found.dynamic, {xx * c + xy * s, xy * c + yy * s}, 1e5);
  EXPECT_EQ(found.held.x, held.x);
  EXPECT_EQ(found.held.y, held.y);
}

TEST_P(BoundaryTraction, IsTheSumOfItsParts) {
  const Traction found = boundary_traction(face_, v_domain, field, held);
  expect_near(
      found.total(),
      {found.viscous.x + found.dynamic.x + found.held.x, found.viscous.y + found.dynamic.y + found.held.y},
      std::abs(held.x));
}

/// A part that nothing calls for is zero, to the last bit.
TEST_P(BoundaryTraction, LeavesOutWhatIsNotThere) {
  const Traction still = boundary_traction(face_, field.velocity, field, {});
  EXPECT_EQ(still.viscous.x, 0.0);
  EXPECT_EQ(still.viscous.y, 0.0);
  const Traction no_dashpots = boundary_traction({face_.normal, 0.0, 0.0}, v_domain, field, {});
  EXPECT_EQ(no_dashpots.viscous.x, 0.0);
  EXPECT_EQ(no_dashpots.viscous.y, 0.0);
  const Traction quiet = boundary_traction(face_, v_domain, {}, {});
  EXPECT_EQ(quiet.dynamic.x, 0.0);
  EXPECT_EQ(quiet.total().x, quiet.viscous.x);
  EXPECT_EQ(quiet.total().y, quiet.viscous.y);
}

/// Dashpots take energy from the difference of the motions, and never give any.
TEST_P(BoundaryTraction, DashpotsOnlyTakeEnergy) {
  for (int direction = 0; direction < 360; direction += 15) {
    const double a = direction * std::numbers::pi / 180.0;
    const Vector v{std::cos(a), std::sin(a)};
    const Vector t = viscous_traction(face_, v);
    const double power = t.x * v.x + t.y * v.y;
    EXPECT_LE(power, -face_.impedance_s * (1.0 - tolerance));
    EXPECT_GE(power, -face_.impedance_p * (1.0 + tolerance));
  }
}

/// Eq. (5): a base that a wave comes up through vertically is pulled by -rho c (v^m - 2 v^inp).
TEST(TransmittingBase, TakesTheIncidentWaveTwice) {
  const Face base{{0.0, -1.0}, 3e5, 1.6e5};
  const Vector incident{0.2, 0.05};
  const FreeField wave{incident, {0.0, -base.impedance_p * incident.y, -base.impedance_s * incident.x}};
  expect_near(boundary_traction(base, v_domain, wave, {}).total(),
              {-base.impedance_s * (v_domain.x - 2.0 * incident.x),
               -base.impedance_p * (v_domain.y - 2.0 * incident.y)},
              base.impedance_p);
}

INSTANTIATE_TEST_SUITE_P(Normals, BoundaryTraction, testing::Values(0.0, 30.0, 90.0, 135.0, 180.0, 270.0));

} // namespace
} // namespace tremolo::eq6
