#pragma once

#include "coupler/participant.hpp"
#include "scene/plan/service.hpp"

#include <string_view>
#include <vector>

namespace tremolo::wavefield {

/// Interval of served steps (s) for a motion whose spectrum ends at a frequency (Hz): 20 steps a period. The
/// Hermite interpolation between them errs by (omega dt)^4/384, at a third of that frequency, where motions
/// end in practice, by 3e-7.
double served_interval(double highest_frequency);

/// The fields of a service, two steps longer at both ends than it is asked for.
/// @param suffix  of their names, for a plane wave that is not the first one
std::vector<coupler::FieldDescription> descriptions(const scene::Service& service, double slowness_x,
                                                    double dt, std::string_view suffix = {});

} // namespace tremolo::wavefield
