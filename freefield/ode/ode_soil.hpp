#pragma once

#include "materials/hysteretic/backbone/backbone.hpp"
#include "materials/hysteretic/masing.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::freefield {

/// Shear stress of cells by Masing rules, for an integrator that tries many states before it accepts one.
///
/// A trial is a function of time, strain and strain rate alone, and changes nothing: between the accepted
/// state and the trial the strain follows the cubic of Hermite through both values and rates. Where the rates
/// differ in sign the cubic has one extremum; there the strain turned back, and the stress is that of the
/// path over this point. Acceptance takes the same path, so the stress is the same before and after it, and
/// no reversal is ever dated to the end of a step.
class OdeSoil {
public:
  /// A cell of the column and its backbone.
  struct Cell {
    std::size_t index = 0;
    materials::Backbone backbone;
  };

  explicit OdeSoil(std::vector<Cell> cells);

  std::span<const Cell> cells() const { return cells_; }

  /// Stress (Pa) of cells()[i] at a time at or after the accepted one, s.
  double stress(std::size_t i, double time, double strain, double strain_rate) const;
  materials::ShearResponse response(std::size_t i, double time, double strain, double strain_rate) const;

  /// Accepts the strains and strain rates (1/s) of all cells(), in their order.
  void accept(double time, std::span<const double> strain, std::span<const double> strain_rate);

private:
  using History = std::array<double, materials::masing_history_size>;

  bool turns(std::size_t i, double time, double strain_rate) const {
    return time > time_ && strain_rate * rate_[i] < 0.0;
  }
  double turning_strain(std::size_t i, double time, double strain, double strain_rate) const;
  History turned(std::size_t i, double time, double strain, double strain_rate) const;

  std::vector<Cell> cells_;
  std::vector<History> history_; ///< accepted
  std::vector<double> strain_, rate_;
  double time_ = 0.0;
};

} // namespace tremolo::freefield
