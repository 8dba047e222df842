#pragma once

#include "freefield/column.hpp"
#include "mpm_domain/column/periodic_column.hpp"
#include "scene/case.hpp"
#include "scene/plan/plan.hpp"

#include <functional>
#include <memory>

namespace tremolo::mpm_domain {

/// One column of the model's coarsest cells under the source's surface: its layers, then the half-space. It
/// reaches down to the base of the model, or by whole cells more to where the half-space begins. Its start is
/// the beginning of the motion; it has the case's fixed step, if there is one.
/// @param x_line  where the column stands, m
/// @throws std::invalid_argument without [mesh], motion::RecordError for an unreadable motion
PeriodicColumnSpec periodic_column_spec(const scene::Case& scene, const scene::SourceProcess& source,
                                        double x_line);

/// v_ref for the particles of the whole domain: of the ground at its left side, or at its base where the
/// sides are no free fields. On a shaking table, from which the domain is seen, it is zero.
/// @throws motion::RecordError for an unreadable motion
std::function<Vector(double x, double time)> rock_motion(const scene::Case& scene, const scene::Plan& plan);

/// The column as a free field that can be sampled at any level, linear between base, rows of particles and
/// surface.
/// @param needed_from  when its motion is first requested, s
/// @throws std::invalid_argument for layers that the column cannot have too
std::unique_ptr<freefield::Column> column_from_case(const scene::Case& scene,
                                                    const scene::SourceProcess& source, double x_line,
                                                    double needed_from);

} // namespace tremolo::mpm_domain
