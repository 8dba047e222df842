#pragma once

// Four doubles at a time (base/lanes.hpp), with names in the domain's namespace.

#include "base/lanes.hpp"

namespace tremolo::mpm_domain {

using tremolo::all;
using tremolo::by_fours;
using tremolo::choose;
using tremolo::clamp;
using tremolo::FewerThanFour;
using tremolo::floor;
using tremolo::Four;
using tremolo::inverse;
using tremolo::LaneMask;
using tremolo::Lanes;
using tremolo::LanesInMemory;
using tremolo::larger;
using tremolo::load;
using tremolo::positive;
using tremolo::smaller;
using tremolo::sqrt;
using tremolo::store;
using tremolo::sum;
using tremolo::transposed;

} // namespace tremolo::mpm_domain
