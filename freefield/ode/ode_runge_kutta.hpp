#pragma once

#include <arkode/arkode_erkstep.h>

#include <memory>

namespace tremolo::freefield {

struct FreeButcherTable {
  void operator()(ARKodeButcherTable table) const { ARKodeButcherTable_Free(table); }
};
using ButcherTable = std::unique_ptr<ARKodeButcherTableMem, FreeButcherTable>;

/// Explicit, third order with an error estimate of second, five evaluations a step, stable for undamped
/// oscillations up to w dt = sqrt(15): per evaluation a third more than Bogacki and Shampine's pair.
ButcherTable wide_runge_kutta();

} // namespace tremolo::freefield
