// In the half of element e at node I, with y_c its centre,
//
//     p = p_e - (y - y_c) (rho_f a_f + (rho_f g/k) n_I w_I)    where water flows; a_f = a_s at a sealed node
//     p = p_e - Q/(M + Q) (syy - syy_e), total stress,         where it does not
//     sxy, syy (total) = those of the centre + (y - y_c) [(1-n) rho_s a_s + n rho_f a_f + alpha rho (v_s -
//                                         v_ref)],   v_ref of base_motion.hpp
//     velocity of grains and water together = v_s + rho_f n w/rho
//     sxx = lambda/M of the effective syy, and what yield adds to it at the centres, interpolated, less p

#include "freefield/twophase/wet_snapshot.hpp"

#include <cmath>

namespace tremolo::freefield {
namespace {

double at_centres(const ColumnMesh::Centres& c, const std::vector<double>& values) {
  return (1.0 - c.weight) * values[c.lower] + c.weight * values[c.upper];
}

} // namespace

WetStress stress_at(const WetSnapshot& snapshot, const ColumnMesh& mesh, const WetGrid& grid,
                    const ColumnMesh::Place& place) {
  const std::size_t e = place.element;
  const WetElement& element = grid.elements[e];
  const std::size_t i = place.fraction < 0.5 ? e : e + 1;
  const double from_centre = element.length * (place.fraction - 0.5);
  const auto inertia = [&](double solid, double fluid, double velocity) {
    return element.solid_share * solid + element.fluid_share * fluid +
           element.alpha * element.density * velocity;
  };
  WetStress stress;
  stress.pressure = snapshot.pressure[e];
  if (element.flows())
    stress.pressure -=
        from_centre * (element.fluid_density * snapshot.a_fluid[i].y + element.resistance * snapshot.flux[i]);
  stress.sxy = snapshot.sxy[e] + from_centre * inertia(snapshot.a[i].x, snapshot.a_fluid[i].x,
                                                       snapshot.v[i].x - snapshot.reference.x);
  stress.syy =
      snapshot.syy[e] - snapshot.pressure[e] +
      from_centre * inertia(snapshot.a[i].y, snapshot.a_fluid[i].y, snapshot.v[i].y - snapshot.reference.y);
  stress.pressure -= element.undrained_share * (stress.syy - (snapshot.syy[e] - snapshot.pressure[e]));
  const ColumnMesh::Centres centres = mesh.centres(place);
  const double yielded =
      at_centres(centres, snapshot.sxx) - element.lateral_ratio * at_centres(centres, snapshot.syy);
  stress.sxx = element.lateral_ratio * (stress.syy + stress.pressure) + yielded - stress.pressure;
  return stress;
}

ColumnSample motion_at(const WetSnapshot& snapshot, const ColumnMesh& mesh, const WetGrid& grid,
                       const ColumnMesh::Place& place) {
  const std::size_t e = place.element;
  const WetElement& element = grid.elements[e];
  const auto at = [&](const std::vector<WetSnapshot::Vector>& nodal, double WetSnapshot::Vector::*component) {
    return std::lerp(nodal[e].*component, nodal[e + 1].*component, place.fraction);
  };
  const ColumnMesh::Centres centres = mesh.centres(place);
  const auto strain = [&](double WetSnapshot::Vector::*component) {
    const auto of = [&](std::size_t i) {
      return (snapshot.u[i + 1].*component - snapshot.u[i].*component) / mesh.length(i);
    };
    return (1.0 - centres.weight) * of(centres.lower) + centres.weight * of(centres.upper);
  };
  using Vector = WetSnapshot::Vector;
  ColumnSample sample;
  sample.vx = at(snapshot.v, &Vector::x);
  sample.vy = at(snapshot.v, &Vector::y);
  sample.vx_rate = at(snapshot.a, &Vector::x);
  sample.vy_rate = at(snapshot.a, &Vector::y);
  if (element.flows()) {
    const double mass = element.solid_share + element.fluid_share;
    const auto flux = [&](const std::vector<double>& nodal) {
      return element.fluid_density / mass * std::lerp(nodal[e], nodal[e + 1], place.fraction);
    };
    sample.vx += flux(snapshot.flux_x);
    sample.vy += flux(snapshot.flux);
    sample.vx_rate += element.fluid_share / mass * (at(snapshot.a_fluid, &Vector::x) - sample.vx_rate);
    sample.vy_rate += element.fluid_share / mass * (at(snapshot.a_fluid, &Vector::y) - sample.vy_rate);
  }
  sample.ux = at(snapshot.u, &Vector::x);
  sample.uy = at(snapshot.u, &Vector::y);
  sample.gxy = strain(&Vector::x);
  sample.eyy = strain(&Vector::y);
  return sample;
}

} // namespace tremolo::freefield
