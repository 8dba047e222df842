#pragma once

#include "scene/case.hpp"

namespace tremolo::scene {

/// y of the water table at x, m: on the phreatic line, or where water seeps, on a straight line between the
/// levels at both sides, which is an estimate. The case has [water].
double table_at(const Case& scene, double x);

/// The highest place that the table may have at x, m: where water seeps, the higher level of both sides.
double highest_table_at(const Case& scene, double x);

} // namespace tremolo::scene
