#pragma once

// Constant damping of a column's soil (materials/relaxation/relaxation.cpp), by the stress increments of its
// laws. Where soil has pore pressure, mechanisms bear the deviator in the plane alone, (sxx - syy)/2 and sxy:
// a mean stress of theirs would be effective stress that goes on relaxing for seconds.

#include "freefield/column_mesh.hpp"
#include "freefield/profile.hpp"
#include "materials/relaxation/relaxation.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::freefield {

/// Stress or strain in the plane: Pa, or 1 with engineering shear strain.
struct InPlane {
  double xx = 0.0, yy = 0.0, xy = 0.0;
};

/// Factors on the stiffness of the soil: on that against change of area in the plane, lambda + G, and on that
/// against shear, G.
struct StiffnessFactors {
  double area = 1.0;
  double shear = 1.0;

  /// Multiplies the part of a stress or strain that changes the area, and that which does not.
  InPlane operator()(const InPlane& value) const {
    const double mean = 0.5 * (value.xx + value.yy), deviator = 0.5 * (value.xx - value.yy);
    return {area * mean + shear * deviator, area * mean - shear * deviator, shear * value.xy};
  }
};

class ColumnRelaxation {
public:
  /// @param dt  step of the column, s
  ColumnRelaxation(const Profile& profile, const ColumnMesh& mesh, const Damping& damping, double dt);

  bool acts() const { return acts_; }

  /// The share of an element's strain that its law sees, which is also that of its stiffness that is left
  /// when all has relaxed.
  const StiffnessFactors& seen(std::size_t element) const { return soil(element).seen; }
  /// Stiffness of law and mechanisms together over a step, relative to that of the soil.
  const StiffnessFactors& over_a_step(std::size_t element) const { return soil(element).over_a_step; }
  /// The moduli of the elements while nothing has had the time to relax, G_U/G times those of the laws: they
  /// bound the step. Pa.
  std::vector<double> unrelaxed(std::vector<double> moduli) const;

  /// Stress of all mechanisms of an element, Pa.
  InPlane stress(std::size_t element) const;
  /// The stress that remains of it after a step in which the law's stress does not change, Pa.
  InPlane kept(std::size_t element) const;
  /// The fraction of an increment of the law's stress that the mechanisms relax in a step.
  const StiffnessFactors& taken(std::size_t element) const { return soil(element).taken; }
  /// Makes a step.
  void advance(std::size_t element, const InPlane& law_increment);

private:
  /// One kind of soil.
  struct Soil {
    materials::Relaxation relaxation;
    std::vector<materials::RelaxationStep> steps; ///< one a mechanism
    bool has_pressure = false;
    StiffnessFactors seen, over_a_step;
    StiffnessFactors taken{.area = 0.0, .shear = 0.0}; ///< of an increment of the law's stress
  };
  const Soil& soil(std::size_t element) const { return soils_[element_soil_[element]]; }

  std::vector<Soil> soils_; ///< one a layer
  std::vector<std::size_t> element_soil_;
  std::vector<std::vector<InPlane>> memory_; ///< q_j, [element][mechanism], Pa
  bool acts_ = false;
};

} // namespace tremolo::freefield
