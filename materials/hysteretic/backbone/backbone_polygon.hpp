#pragma once

// The polygon by which parallel elements follow a backbone F. The vertices lie a factor 1 + e above the
// backbone, spaced such that the sides sag as far below it; the first side ends where the backbone has lost
// the fraction e of G0, so that its slope is G0 exactly. With q = gamma^2 |F''|/F the sag of a side of length
// h in ln(gamma) is q h^2/8, hence h = sqrt(16 e/q), and e follows from the number of vertices. Beyond the
// largest strain the polygon is level: a finite strength for any exponent.

#include "materials/hysteretic/backbone/backbone.hpp"
#include "materials/hysteretic/iwan_elements.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::materials {

/// The `count` vertices; the last one lies at the largest strain.
std::vector<CurveVertex> polygon(const Backbone& backbone, std::size_t count, double largest_strain);

} // namespace tremolo::materials
