#pragma once

#include "mpm_domain/head/head.hpp"
#include "mpm_domain/spec/spec.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// x and y of places on the phreatic surface and on free water, a cell apart, from the left side of a model
/// to its right one, m.
std::vector<double> phreatic_line(const Spec& spec, const Head& head);

} // namespace tremolo::mpm_domain
