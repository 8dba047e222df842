#pragma once

// Loading of the specimen by the apparatus of a soil test in one increment, and its measurements (the table
// at the top of soil_test.hpp).

#include "materials/soiltest/soil_test.hpp"

namespace tremolo::soiltest {

class Apparatus {
public:
  /// @param start  the specimen before loading; stresses held constant are those of now
  Apparatus(const SoilTest& test, const materials::PointTest& start);

  /// The step that drives the test by a strain increment: of gamma_xy, or of eps_a.
  materials::PointStep step(double increment, const materials::PointTest& point) const;
  /// The step of a path to prescribed strains and stresses.
  materials::PointStep step_to(const Path& path, const PathRow& goal,
                               const materials::PointTest& point) const;

  /// gamma_xy or eps_a = -eps_yy
  double strain(const materials::PointTest& point) const;
  /// gamma, engineering: that of tau
  double shear_strain(const materials::PointTest& point) const;
  /// tau, Pa
  double shear_stress(const materials::PointTest& point) const;
  /// u, Pa
  double pore_pressure(const materials::PointTest& point) const;
  /// r_u
  double pore_pressure_ratio(const materials::PointTest& point) const {
    return pore_pressure(point) / reference_stress_;
  }
  /// Whether the specimen strains out of plane.
  bool out_of_plane() const { return out_of_plane_; }

private:
  materials::PointStep shear_step(double increment, double water) const;
  materials::PointStep axial_step(double increment, double water) const;
  bool shears() const { return test_.kind == Kind::direct_simple_shear || test_.kind == Kind::path; }
  bool triaxial() const {
    return test_.kind == Kind::triaxial_compression || test_.kind == Kind::triaxial_extension;
  }

  const SoilTest& test_;
  materials::PointStress start_;
  double reference_stress_ = 0.0; ///< what r_u refers to, Pa, compression positive
  bool out_of_plane_ = false;
};

} // namespace tremolo::soiltest
