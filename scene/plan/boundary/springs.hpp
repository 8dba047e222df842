#pragma once

// Springs beside dashpots (mpm_domain/boundary/springs/ground_springs.hpp): which sides have them, how stiff,
// and around which centre.

#include "scene/case.hpp"

#include <optional>
#include <string>

namespace tremolo::scene {

struct PlannedSprings {
  double across = 0.0; ///< a_n of k_n = a_n G/R
  double along = 0.0;  ///< a_t
  Point centre;        ///< that R is measured from, m
  bool lags = false;   ///< at a base between two different free fields
};

/// Whether springs of the base have no total field to move against: it takes the incident wave alone, and
/// the sides have no free field.
bool base_has_no_total_field(const Case& scene);

/// On the ground's surface in the middle of all structures; without any, in the middle of the box at the mean
/// of both surfaces.
Point spring_centre(const Case& scene);

/// The springs of a side; nothing if it has none.
std::optional<PlannedSprings> springs(const Case& scene, Side side);

/// "left, right: 1 and 0.5 G/R around (0, 0) m; ..."
std::string springs_text(const Case& scene);

} // namespace tremolo::scene
