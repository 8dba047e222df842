#include "materials/soiltest/apparatus.hpp"

#include <algorithm>

namespace tremolo::soiltest {

using materials::Control;
using materials::PointStep;
using materials::PointTest;

Apparatus::Apparatus(const SoilTest& test, const PointTest& start) : test_(test), start_(start.stress()) {
  const bool lateral =
      triaxial() || test.kind == Kind::plane_strain_compression || test.kind == Kind::plane_strain_extension;
  reference_stress_ = lateral ? -start_.xx : -start_.yy;
  out_of_plane_ =
      triaxial() || (test.kind == Kind::isotropic_compression && traits(start.law()).three_dimensional);
  if (const Path* path = std::get_if<Path>(&test.loading)) {
    out_of_plane_ =
        path->by_stress[3] || std::any_of(path->rows.begin(), path->rows.end(),
                                          [](const PathRow& row) { return row.strain.zz != 0.0; });
  }
}

PointStep Apparatus::shear_step(double increment, double water) const {
  PointStep step;
  step.xy = Control::strain(increment);
  if (test_.drainage != Drainage::constant_volume)
    step.yy = Control::stress(start_.yy + water);
  return step;
}

PointStep Apparatus::axial_step(double increment, double water) const {
  PointStep step;
  step.yy = Control::strain(-increment);
  if (test_.drainage != Drainage::constant_volume) {
    step.xx = Control::stress(start_.xx + water);
    if (triaxial())
      step.zz = Control::stress(start_.zz + water);
  } else if (triaxial()) {
    step.xx = step.zz = Control::strain(0.5 * increment);
  } else {
    step.xx = Control::strain(increment);
  }
  return step;
}

PointStep Apparatus::step(double increment, const PointTest& point) const {
  const double water = test_.drainage == Drainage::undrained ? pore_pressure(point) : 0.0;
  PointStep step;
  switch (test_.kind) {
  case Kind::direct_simple_shear:
  case Kind::path:
    step = shear_step(increment, water);
    break;
  case Kind::oedometer:
    step.yy = Control::strain(-increment);
    break;
  case Kind::isotropic_compression:
    step.xx = step.yy = Control::strain(-increment);
    step.zz = Control::strain(out_of_plane_ ? -increment : 0.0);
    break;
  default:
    step = axial_step(increment, water);
  }
  step.pore_stiffness = test_.pore_stiffness;
  return step;
}

PointStep Apparatus::step_to(const Path& path, const PathRow& goal, const PointTest& point) const {
  const double water = test_.drainage == Drainage::undrained ? pore_pressure(point) : 0.0;
  const auto control = [&](std::size_t i, double strain, double now, double stress) {
    return path.by_stress[i] ? Control::stress(stress) : Control::strain(strain - now);
  };
  const materials::PointStrain& now = point.strain();
  PointStep step;
  step.xx = control(0, goal.strain.xx, now.xx, goal.stress.xx + water);
  step.yy = control(1, goal.strain.yy, now.yy, goal.stress.yy + water);
  step.xy = control(2, goal.strain.xy, now.xy, goal.stress.xy);
  step.zz = control(3, goal.strain.zz, now.zz, goal.stress.zz + water);
  step.pore_stiffness = test_.pore_stiffness;
  return step;
}

double Apparatus::strain(const PointTest& point) const {
  return shears() ? point.strain().xy : -point.strain().yy;
}

double Apparatus::shear_strain(const PointTest& point) const {
  return shears() ? point.strain().xy : point.strain().xx - point.strain().yy;
}

double Apparatus::shear_stress(const PointTest& point) const {
  return shears() ? point.stress().xy : 0.5 * (point.stress().xx - point.stress().yy);
}

double Apparatus::pore_pressure(const PointTest& point) const {
  switch (test_.drainage) {
  case Drainage::undrained:
    return -test_.pore_stiffness * (point.strain().xx + point.strain().yy + point.strain().zz);
  case Drainage::constant_volume:
    return reference_stress_ + (shears() ? point.stress().yy : point.stress().xx);
  default:
    return 0.0;
  }
}

} // namespace tremolo::soiltest
