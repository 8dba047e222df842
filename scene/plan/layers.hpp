#pragma once

#include "scene/plan/plan.hpp"

#include <optional>
#include <vector>

namespace tremolo::scene {

/// The layers under a side's surface, from the top down.
const std::vector<Layer>& layers(const Case& scene, const LateralBoundary& side);

/// The layers of a source.
const std::vector<Layer>& layers(const Case& scene, const SourceProcess& source);

/// y of the water table below a source's surface, m; only with [water].
double water_level(const Case& scene, const SourceProcess& source);

/// Whether any of them has viscous damping.
bool damped(const std::vector<Layer>& layers);

/// y of the top of the half-space, m.
double base_level(double surface, const std::vector<Layer>& layers);

/// The ground below the base of the model if it differs from the model's lowest soil: the half-space under a
/// base at or below its top, the next layer under a base at an interface. Empty for a base within a layer,
/// whose own soil goes on below; where the layer below is a nonlinear soil, whose stiffness depends on its
/// stress; and where the profiles of both sides do not agree.
std::optional<materials::Elasticity> ground_below_base(const Case& scene);

/// Ascending levels (m), with each interface of the layers above the lowest of them twice: stress and strain
/// jump there, and a source that is asked twice answers from below and from above. Levels as near to an
/// interface as `close` (m) give way to it, the lowest and the highest excepted.
std::vector<double> with_interfaces(std::vector<double> levels, double surface,
                                    const std::vector<Layer>& layers, double close);

} // namespace tremolo::scene
