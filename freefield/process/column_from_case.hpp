#pragma once

#include "freefield/column.hpp"
#include "scene/case.hpp"
#include "scene/plan/plan.hpp"

#include <functional>
#include <memory>

namespace tremolo::freefield {

/// The column of a source, at rest before the motion begins: the layers under the source's surface, and soil
/// of the half-space below them down to the base of the model. Under a motion within the ground it ends at
/// the top of the half-space, which moves as given.
/// @param x_line  where the column stands, m: an oblique wave passes it earlier or later
/// @param needed_from  when its motion is first asked for, s; it starts two steps before
/// @throws std::invalid_argument for values out of range, motion::RecordError for an unreadable motion
std::unique_ptr<Column> column_from_case(const scene::Case& scene, const scene::SourceProcess& source,
                                         double x_line, double needed_from);

/// v_ref of damping in proportion to mass (base_motion.hpp), m/s, at x (m) and a time (s).
using RockMotion = std::function<Velocity(double x, double time)>;

/// Motion of the rock below a source's ground without the soil. No wave may come up beyond the critical angle
/// of the half-space.
RockMotion rock_motion(const scene::Case& scene, const scene::SourceProcess& source);

} // namespace tremolo::freefield
