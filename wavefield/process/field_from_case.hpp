#pragma once

#include "scene/case.hpp"
#include "scene/plan/plan.hpp"
#include "wavefield/layers/equivalent_linear.hpp"
#include "wavefield/superposition.hpp"

#include <span>
#include <string>
#include <vector>

namespace tremolo::wavefield {

/// The field of a source: elastic layers for model "wave", strain-compatible ones for "eql".
/// @throws as incident_signal(); std::runtime_error for an equivalent-linear iteration that does not converge
Superposition field_from_case(const scene::Case& scene, const scene::SourceProcess& source);

/// The equivalent-linear iteration of a source, under the SV wave; a P wave beside it comes up vertically and
/// shears nothing.
EquivalentLinearResult equivalent_linear_from_case(const scene::Case& scene,
                                                   const scene::SourceProcess& source);

/// The iteration under a motion recorded in the ground (m/s2) instead of the case's own.
EquivalentLinearResult equivalent_linear_from_case(const scene::Case& scene,
                                                   const scene::SourceProcess& source,
                                                   const RecordedMotion& record);

/// The layers of an iteration's result, by index, whose effective strain lies beyond the last one of their
/// soil's table.
std::vector<std::size_t> layers_beyond_their_curves(const scene::Case& scene,
                                                    const scene::SourceProcess& source,
                                                    std::span<const double> largest_strains);

/// The field in the layers of an iteration's result.
Superposition field_from_case(const scene::Case& scene, const scene::SourceProcess& source,
                              const EquivalentLinearResult& result);

/// A text on whether the iteration converged, in how many steps, its largest strain, and where the damping of
/// the curves was too large for the complex moduli.
std::string summary(const EquivalentLinearResult& result);

/// The levels on the vertical line at x; of a level that stands twice, the first from below.
std::vector<Point> points_on_line(double x, std::span<const double> levels);

} // namespace tremolo::wavefield
