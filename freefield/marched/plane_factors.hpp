#pragma once

#include "freefield/column_relaxation.hpp"

#include <Eigen/Core>

namespace tremolo::freefield {

/// Factors on the in-plane mean, the deviator and xy of stress or strain in the elements of a column.
class PlaneFactors {
public:
  void resize(Eigen::Index elements) {
    for (Eigen::ArrayXd* values : {&half_mean_, &half_deviator_, &xy_})
      values->setZero(elements);
  }

  /// Shares of stress or strain.
  void set(Eigen::Index element, const StiffnessFactors& of) {
    half_mean_[element] = 0.5 * of.area;
    half_deviator_[element] = 0.5 * of.shear;
    xy_[element] = of.shear;
  }
  /// Stiffness, from strain with the engineering shear to stress.
  /// @param area, shear  lambda + G and G, Pa
  void set(Eigen::Index element, const StiffnessFactors& of, double area, double shear) {
    half_mean_[element] = of.area * area;
    half_deviator_[element] = xy_[element] = of.shear * shear;
  }

  /// @param result  other than the fields
  void apply(const auto& fields, auto&& result) const {
    const auto xx = fields.col(0), yy = fields.col(1);
    result.col(0) = half_mean_ * (xx + yy) + half_deviator_ * (xx - yy);
    result.col(1) = half_mean_ * (xx + yy) - half_deviator_ * (xx - yy);
    result.col(2) = xy_ * fields.col(2);
  }

private:
  Eigen::ArrayXd half_mean_, half_deviator_, xy_;
};

} // namespace tremolo::freefield
