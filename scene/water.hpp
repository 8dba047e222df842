#pragma once

#include "materials/water/pore_water.hpp"
#include "scene/choices.hpp"
#include "scene/geometry.hpp"

#include <algorithm>
#include <optional>

namespace tremolo::scene {

/// Levels of the water at both sides of the model, m.
struct SideLevels {
  double left = 0.0;
  double right = 0.0;
};

/// [water]: the undisturbed ground water and what water is. Water over the ground is free water that the
/// ground carries.
struct GroundWater {
  double level = 0.0; ///< y of the table; where that is not level, of the one at the left side, m
  materials::PoreFluid fluid;
  Polygon line = {};                      ///< corners of a phreatic line that is not level; otherwise empty
  std::optional<SideLevels> seepage = {}; ///< water flows between these
  /// Soil above the table is wet up to this level, since it could not drain, m.
  std::optional<double> still_wet = {};

  bool is_level() const { return line.empty() && !seepage; }
  /// The level at a side, and below its free field, m.
  double beside(Side side) const {
    if (seepage)
      return side == Side::right ? seepage->right : seepage->left;
    if (!line.empty())
      return side == Side::right ? line.back().y : line.front().y;
    return level;
  }
  /// The level at a side whose ground has a surface (m): soil holds water that could not drain up to there.
  double beside(Side side, double surface) const {
    return still_wet ? std::max(level, std::min(*still_wet, surface)) : beside(side);
  }
  /// The highest level that there is, m.
  double highest() const {
    if (!line.empty())
      return std::ranges::max(line, {}, &Point::y).y;
    return std::max({beside(Side::left), beside(Side::right), still_wet.value_or(level)});
  }

  /// Pressure at y of water at rest below a table, Pa; 0 above it.
  double pressure(double y, double gravity) const {
    return y < level ? fluid.density * gravity * (level - y) : 0.0;
  }
};

/// Water that rests below a level table (m), of the same fluid.
inline GroundWater at_level(const GroundWater& water, double level) {
  return {level, water.fluid};
}

} // namespace tremolo::scene
