#pragma once

#include "freefield/column.hpp"
#include "scene/case.hpp"
#include "scene/plan/plan.hpp"
#include "wavefield/layers/layered_half_space.hpp"

namespace tremolo::freefield {

/// Input motion at the base of a column.
struct ColumnInput {
  BaseKind base = BaseKind::compliant;
  InputVelocity velocity;
  double begin = 0.0;             ///< s; zero before
  double highest_frequency = 0.0; ///< Hz
};

/// An incident wave where it passes a point of the half-space, m.
/// @throws motion::RecordError for an unreadable motion
ColumnInput incident_input(const scene::MotionInput& wave, const wavefield::LayeredHalfSpace& ground,
                           double x, double y);
/// Both together.
ColumnInput sum(ColumnInput first, const ColumnInput& second);

/// All incident waves where they pass a point of the half-space, m.
/// @throws motion::RecordError for an unreadable motion
ColumnInput incident_input(const scene::Case& scene, const scene::SourceProcess& source, double x, double y);

} // namespace tremolo::freefield
