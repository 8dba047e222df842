#pragma once

#include "freefield/fe/fe_elements.hpp"
#include "freefield/fe/fe_newton.hpp"
#include "freefield/fe/fe_settings.hpp"
#include "freefield/fe/fe_soil.hpp"

#include <array>
#include <vector>

namespace tremolo::freefield {

/// A column of soil that follows laws: linear elements with lumped mass, two degrees of freedom a node, one
/// material point an element. Starts at rest under its own weight.
class NonlinearColumn {
public:
  /// @throws std::invalid_argument for an explicit step over the stability limit of the soil at small strain
  NonlinearColumn(const Profile& profile, const ColumnMesh& mesh, const FeColumnSettings& settings);

  /// Advances by the settings' time step from `time`. Where Newton's method does not converge, the step is
  /// halved inside, down to 1/1024.
  /// @throws std::runtime_error naming element, depth and time if it does not converge even then, or if the
  ///         motion is no longer finite
  void step(const InputVelocity& input, double time);

  ColumnSample sample(const ColumnMesh::Place& place) const;
  ColumnEnergy energy() const;
  NewtonCounts counts() const { return {newton_.iterations(), halved_}; }

private:
  /// Stresses over the geostatic ones at the element centres, without damping, Pa.
  struct CentreStress {
    std::vector<double> sxx, syy, sxy;
  };

  void step_explicit(const InputVelocity& input, double time);
  void step_implicit(const InputVelocity& input, double time, double dt, int halvings);
  void account(const FeMotion& before, double dt);
  void sample_stress(const ColumnMesh::Place& place, const ColumnMesh::Centres& centres,
                     ColumnSample& sample) const;
  double stress_rate(std::vector<double> CentreStress::*component, std::size_t element) const;
  /// Difference of a component of a nodal quantity over an element, by its length.
  double gradient(const std::vector<double>& nodal, std::size_t element, std::size_t component) const;
  CentreStress centre_stress() const;
  void remember();

  ColumnMesh mesh_;
  FeColumnSettings settings_;
  Rise rise_;
  FeElements elements_;
  FeSoil soil_;
  FeNewton newton_;
  FeState state_;
  FeMotion before_;                           ///< a step ago
  std::vector<double> du_, deyy_, dgxy_;      ///< increments of an explicit step; m, 1
  std::array<double, 2> reference_rate_{};    ///< of v_ref over the step, x and y, m/s2
  std::vector<double> acceleration_, jerk_;   ///< of the equation of motion at the step's end; m/s2, m/s3
  std::array<CentreStress, 3> centre_stress_; ///< now, one and two steps ago
  double largest_traction_ = 0.0;             ///< so far, Pa
  double base_work_ = 0.0;                    ///< J/m2
  double damping_ = 0.0;                      ///< J/m2
  long halved_ = 0;
};

} // namespace tremolo::freefield
