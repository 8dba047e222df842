#pragma once

// A flat elastic box shaken by a plane wave through all its faces, without processes: the free field of its
// faces is the closed form.

#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "tests/support/plane_wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace tremolo::test_support {

inline mpm_domain::Spec elastic_box(double width, double depth, double h) {
  mpm_domain::Spec spec;
  spec.box = {0.0, -depth, width, 0.0};
  spec.cell_size = h;
  spec.soils = {{"soil", materials::LinearElastic{{1700.0, 40e6, 0.28}}}};
  spec.regions = {{0, {{0.0, -depth}, {width, -depth}, {width, 0.0}, {0.0, 0.0}}}};
  spec.threads = 2;
  return spec;
}

/// The closed form on every face; the base takes the total field or the incident wave alone. The whole scene
/// may move at a constant velocity.
/// @param domain outlives what is returned
inline mpm_domain::FreeFieldSource plane_wave_source(const mpm_domain::Domain& domain, const PlaneWave& wave,
                                                     bool total_base, Vector drift = {}) {
  return [&domain, wave, total_base, drift](long, double t, std::span<const Vector>,
                                            std::span<eq6::FreeField> field) {
    for (std::size_t f = 0; f < field.size(); ++f) {
      const mpm_domain::BoundaryFace& face = domain.boundary.faces()[f];
      const bool incident = face.side == mpm_domain::Side::base && !total_base;
      field[f] = wave.at(face.position.x, face.position.y, t, incident ? 1 : 3);
      field[f].velocity.x += drift.x;
      field[f].velocity.y += drift.y;
    }
  };
}

/// Relative L2 error of particle velocity over the box and the time of the run, against the closed form.
class VelocityError {
public:
  void add(const mpm_domain::Domain& domain, const PlaneWave& wave, double velocity_time, Vector drift = {}) {
    for (const mpm_domain::Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k) {
        const eq6::Vector exact = wave.at(set.x_initial[k], set.y_initial[k], velocity_time).velocity;
        const eq6::Vector v = mpm_domain::particle_velocity(domain, set, k);
        error_ += std::pow(v.x - drift.x - exact.x, 2) + std::pow(v.y - drift.y - exact.y, 2);
        norm_ += exact.x * exact.x + exact.y * exact.y;
      }
  }
  double relative() const { return std::sqrt(error_ / norm_); }

private:
  double error_ = 0.0;
  double norm_ = 0.0;
};

struct BoxResult {
  double error = 0.0;    ///< relative L2 of particle velocity over the box and 2.2 s
  double residual = 0.0; ///< largest residual of the energy ledger over the work put in through the boundary
  double dashpots = 0.0; ///< their largest work on the soil's own velocity, J/m: they only take
};

/// A box of 100 m by 40 m in cells of h (m) under an oblique SV wave, for 2.2 s.
/// @param matched_sides  with matched layers
inline BoxResult run_box(double h, double angle_deg, bool total_base, const mpm_domain::Scheme& scheme = {},
                         const std::vector<mpm_domain::Side>& matched_sides = {}) {
  mpm_domain::Spec spec = elastic_box(100.0, 40.0, h);
  spec.scheme = scheme;
  spec.matched_sides = matched_sides;
  mpm_domain::Domain domain(spec);
  PlaneWave wave;
  wave.angle = angle_deg * std::numbers::pi / 180.0;
  mpm_domain::Stepper stepper(domain, 0.0, plane_wave_source(domain, wave, total_base));
  VelocityError error;
  double input = 0.0;
  BoxResult result;
  while (stepper.time() < 2.2) {
    stepper.step();
    if (stepper.steps() % 8 == 0)
      error.add(domain, wave, stepper.velocity_time());
    input = std::max(input, domain.energy.input);
    result.residual = std::max(result.residual, std::abs(domain.energy.residual()));
    result.dashpots = std::max(result.dashpots, domain.energy.dashpots);
  }
  result.residual /= input;
  result.error = error.relative();
  return result;
}

} // namespace tremolo::test_support
