// In the half of element e at node I, with y_c its centre and F the rate of the bracket at the node,
//
//     (sxy, Syy) = those of the centre + (y - y_c) F rho_e/m_I,   p = p_e - (y - y_c) F~ rho_f/m~_f,
//     p = p_e - Q/(M + Q) [Syy - Syy_e - 2 G s (vx - vx_e)]       where water does not flow,
//     sxx = lambda/M syy' - (M - lambda^2/M) s vx, and what yield adds to it at the centres, interpolated,
//     less p.
//
// Both elements at a node give the same, and a free, drained surface gives zero.

#include "freefield/marched/marched_snapshot.hpp"

#include <cmath>

namespace tremolo::freefield {

/// sxx of elastic soil by its horizontal strain -s vx at syy' = 0, Pa.
double MarchedSnapshot::lateral_by_motion(const WetElement& element, double p_modulus, double vx) const {
  return -(1.0 - element.lateral_ratio * element.lateral_ratio) * p_modulus * slowness * vx;
}

ColumnSample MarchedSnapshot::at(const ColumnMesh& mesh, const WetGrid& grid,
                                 const ColumnMesh::Place& place) const {
  const std::size_t e = place.element;
  const std::size_t i = place.fraction < 0.5 ? e : e + 1;
  const WetElement& element = grid.elements[e];
  const WetNode& node = grid.nodes[i];
  const double density = element.solid_share + element.fluid_share;
  const double from_centre = element.length * (place.fraction - 0.5);
  const auto between = [&](const auto& below, const auto& above) {
    return Eigen::Vector2d(below + place.fraction * (above - below));
  };
  const auto centre_vx = [&](std::size_t c) {
    return 0.5 * (velocity[c].solid.x() + velocity[c + 1].solid.x());
  };

  const ElementStress& centre = stress[e];
  const Eigen::Vector2d slope = density / node.mass() * force[i];
  const double sxy = centre.xy + from_centre * slope.x();
  const double syy = centre.yy - centre.pressure + from_centre * slope.y();
  const Eigen::Vector2d solid = between(velocity[e].solid, velocity[e + 1].solid);
  double pressure = centre.pressure;
  if (element.flows())
    pressure -= from_centre * fluid_force[i] * element.fluid_density / node.full;
  else
    pressure -=
        element.undrained_share * (from_centre * slope.y() - 2.0 * element.shear_ratio * modulus[e] *
                                                                 slowness * (solid.x() - centre_vx(e)));

  const ColumnMesh::Centres centres = mesh.centres(place);
  const auto yielded = [&](std::size_t c) {
    return stress[c].xx - element.lateral_ratio * stress[c].yy -
           lateral_by_motion(element, modulus[c], centre_vx(c));
  };
  const double modulus_here = std::lerp(modulus[centres.lower], modulus[centres.upper], centres.weight);
  const double sxx = element.lateral_ratio * (syy + pressure) +
                     lateral_by_motion(element, modulus_here, solid.x()) +
                     std::lerp(yielded(centres.lower), yielded(centres.upper), centres.weight) - pressure;

  Eigen::Vector2d mean = solid;
  if (element.flows()) {
    const auto flux = [&](std::size_t k) -> Eigen::Vector2d {
      return grid.nodes[k].porosity() * velocity[k].relative;
    };
    mean += element.fluid_density / density * between(flux(e), flux(e + 1));
  }
  const auto strain = [&](std::size_t c) -> Eigen::Vector2d { return (u[c + 1] - u[c]) / mesh.length(c); };
  const Eigen::Vector2d strained =
      (1.0 - centres.weight) * strain(centres.lower) + centres.weight * strain(centres.upper);
  const Eigen::Vector2d displaced = between(u[e], u[e + 1]);
  return {.vx = mean.x(),
          .vy = mean.y(),
          .sxx = sxx,
          .syy = syy,
          .sxy = sxy,
          .ux = displaced.x(),
          .uy = displaced.y(),
          .eyy = strained.y(),
          .gxy = strained.x() - slowness * solid.y(),
          .pore_pressure = pressure};
}

} // namespace tremolo::freefield
