#pragma once

#include "wavefield/signal/signal.hpp"

namespace tremolo::wavefield {

/// The slow part of a signal: its spectrum times exp(-(f/corner)^4), which is 1e-10 at 2.2 corners. What is
/// left of the signal without it begins like f^4 at zero frequency.
/// @param corner  Hz, below a fourth of the highest frequency
Signal low_passed(const Signal& signal, double corner);

} // namespace tremolo::wavefield
