// Normals between soil and structures from the structure's polygon or from the gradient of the soil's volume:
// a block that slides down an incline of dry soil, and a tunnel in liquefied soil. Prints
//
//     scene, normals, angle, cell_size, error, tangential
//
// error of the acceleration, over g sin(angle) (incline, degrees), or of the lift over that of the heavy
// fluid (tunnel, mean over four places of its axis between nodes); rest along the surface of the force that
// pressure has there, over the force (tunnel).

#include "tests/support/inclined_block.hpp"
#include "tests/support/liquefied_tunnel.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace tremolo::cost {
namespace {

using namespace mpm_domain;
using namespace test_support;

void slide(ContactNormals normals) {
  for (const double degrees : {5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 37.5, 45.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const double friction = 0.5 * std::tan(angle);
    Spec spec = inclined_block(angle, friction);
    spec.normals = normals;
    StandingScene scene(spec);
    const double error = measured_acceleration(scene, angle) - exact_acceleration(angle, friction);
    fmt::print("incline,{},{},0.5,{:.4g},\n", name(normals), degrees,
               std::abs(error) / (9.81 * std::sin(angle)));
    std::fflush(stdout);
  }
}

void lift(ContactNormals normals) {
  for (const double h : {1.0, 0.5, 0.25, 0.125}) {
    double error = 0.0;
    double tangential = 0.0;
    constexpr double positions[] = {0.0, 0.13, 0.29, 0.41};
    for (const double position : positions) {
      Spec spec = saturated_flat_ground(20.0, 12.0, h, materials::Drainage::undrained, 1e7);
      spec.normals = normals;
      const TunnelForces forces = tunnel_forces(spec, position * h);
      error += std::abs(forces.total_lift() / TunnelForces::of_fluid - 1.0) / std::size(positions);
      tangential += forces.along / forces.pressed / std::size(positions);
    }
    fmt::print("tunnel,{},,{},{:.4g},{:.4g}\n", name(normals), h, error, tangential);
    std::fflush(stdout);
  }
}

} // namespace
} // namespace tremolo::cost

int main() {
  using namespace tremolo;
  fmt::print("scene,normals,angle,cell_size,error,tangential\n");
  for (const auto normals : {mpm_domain::ContactNormals::polygon, mpm_domain::ContactNormals::gradient}) {
    cost::slide(normals);
    cost::lift(normals);
  }
}
