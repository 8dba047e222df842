#pragma once

// Plane waves in linear ground add up: their velocities, displacements, strains and stresses are the sums of
// those that each makes alone. They may have horizontal slownesses of their own.

#include "wavefield/layers/layered_field.hpp"

#include <span>
#include <vector>

namespace tremolo::wavefield {

/// Series by series, of the same points and times.
void add(History& sum, const History& other);

/// The fields of one or several plane waves in one ground.
class Superposition {
public:
  /// @param waves  at least one
  /// @throws std::invalid_argument without any
  explicit Superposition(std::vector<LayeredField> waves);

  std::span<const LayeredField> waves() const { return waves_; }

  /// Samples all waves together, like LayeredField::sample().
  std::vector<History> sample(std::span<const Point> points, const TimeGrid& grid, Part part = Part::total,
                              const Quantities& quantities = {}) const;

private:
  std::vector<LayeredField> waves_;
};

} // namespace tremolo::wavefield
