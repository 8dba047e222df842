#pragma once

#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

class Contact;
class Props;

/// Props in a step; none where there are none.
std::vector<Pass> prop_passes(Ground& ground, Contact& contact, Props& props);

} // namespace tremolo::mpm_domain
