// A tower on rock that a load along its height, w per metre, bends towards a prop at the height a. Beside a
// cantilever of Timoshenko's beam with EI and GA_s, of height H,
//
//     u_w = w a^2 (6 H^2 - 4 H a + a^2)/(24 EI) + w (H a - a^2/2)/GA_s,      f = a^3/(3 EI) + a/GA_s,
//
// the prop takes R = u_w/(f + 1/k).

#include "tests/verification/mpm_domain/construction/stages.hpp"

#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::rectangle;
using test_support::structure;

constexpr double height = 6.0, width = 1.0, density = 2000.0; // m, kg/m3
constexpr double young = 2e8, poisson = 0.2;                  // Pa
constexpr double at_height = 5.5;                             // a, m
constexpr double stiffness = 2e5;                             // k, N/m2
constexpr double load = 3e3;                                  // w H, N/m
constexpr double bending = young / (1.0 - poisson * poisson) * width * width * width / 12.0;
constexpr double shearing = 5.0 / 6.0 * young / (2.0 * (1.0 + poisson)) * width;

constexpr double way_of_load() {
  const double w = load / height;
  const double a = at_height;
  return w * a * a * (6.0 * height * height - 4.0 * height * a + a * a) / (24.0 * bending) +
         w * (height * a - 0.5 * a * a) / shearing;
}
constexpr double way_of_force = at_height * at_height * at_height / (3.0 * bending) + at_height / shearing;
constexpr double reaction = way_of_load() / (way_of_force + 1.0 / stiffness);

/// The tower, a rigid block beside it, and a prop between them.
Spec propped() {
  Spec spec = flat_ground(10.0, 1.0, 0.25, {2000.0, 5e9, 0.2});
  spec.box.y_max =
      30.0; // relaxation is damped as a layer of the box's depth asks for, and the tower is as slow
  spec.threads = 1;
  spec.structures = {structure(rectangle(0.0, 0.0, width, height), density, 1.0),
                     structure(rectangle(-4.0, 0.0, -2.0, 7.0), density, 1.0)};
  spec.structures[0].name = "tower";
  spec.structures[0].stiffness = Stiffness{young, poisson};
  spec.structures[1].name = "abutment";
  Prop prop;
  prop.name = "strut";
  prop.from = {"tower", {0.0, at_height}};
  prop.to = {"abutment", {-2.0, at_height}};
  prop.stiffness = stiffness;
  spec.props = {prop};
  spec.structure_loads = {{"tower", {-load, 0.0}}};
  return spec;
}

TEST(ProppedCantilever, PressesOntoThePropAsABeamDoes) {
  Domain domain(propped());
  test::rest(domain, {}, 1e-7);
  const double force = domain.props.all()[0].spring.force();
  RecordProperty("reaction", std::to_string(-force / reaction));
  EXPECT_NEAR(force, -reaction, 0.02 * reaction);
}

} // namespace
} // namespace tremolo::mpm_domain
