#pragma once

#include "scene/plan/plan.hpp"

#include <string_view>

namespace tremolo::scene {

/// The machine of a source, from the entry in [hosts] of a side that it serves.
/// @returns nullptr for one that runs where the run is started
const Host* host_of(const Case& scene, const SourceProcess& source);

/// Whether a text is `tcp://ADDRESS:PORT` with ADDRESS a name, a number, [an IPv6 number] or *, and PORT a
/// number from 1 to 65535 or *.
bool is_tcp_endpoint(std::string_view text);

} // namespace tremolo::scene
