// Points at which nodes bear on a rigid body. The impulse at a node stands for the traction on the piece of
// surface around it, of which the node itself lies up to a cell off: beside the surface, or beyond its end. A
// body that began to tilt would turn about that place, as if it were larger than it is, and one that rolls
// would have as many radii as nodes. So the arm of a node ends on the surface: at the point next to the node
// along its normal, and at a toe, a corner that sticks out, where the node lies beyond it. The nodes that are
// left when a body stands on its edge bear at the toe too, wherever the grid lies: of those on each side of a
// toe the nearest does, if it is less than a cell away.
//
// Momentum is exact. The soil takes the impulse at the node: angular momentum changes by impulse times the
// distance between both positions.

#include "mpm_domain/contact/contact_nodes.hpp"

namespace tremolo::mpm_domain {

void ContactNodes::bear_on(const BodySurface& surface, const Vector& centre, double h) {
  const auto arm = [&](const Vector& position) { return position - centre; };
  for (ContactNode& c : nodes_) {
    const auto foot = surface.foot(c.position, {-c.normal.x, -c.normal.y});
    if (!foot)
      continue;
    if (foot->toe) {
      c.arm = arm(foot->position);
      continue;
    }
    const double along = dot(c.normal, foot->position - c.position);
    c.arm += along * c.normal;
  }
  for (const BodySurface::Toe& toe : surface.toes()) {
    const Vector end = arm(toe.position);
    for (const Vector& out : toe.normals) {
      ContactNode* nearest = nullptr;
      double least = h * h;
      for (ContactNode& c : nodes_) {
        const double distance2 = square(c.arm - end);
        if (BodySurface::faces(out, {-c.normal.x, -c.normal.y}) && distance2 < least) {
          least = distance2;
          nearest = &c;
        }
      }
      if (nearest != nullptr)
        nearest->arm = end;
    }
  }
}

} // namespace tremolo::mpm_domain
