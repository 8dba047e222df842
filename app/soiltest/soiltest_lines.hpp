#pragma once

// Mean and deviator stress as the law of a soil sees them, and the lines of the law in their plane. With p
// positive in compression,
//
//     in the plane    p = -(sig_xx + sig_yy)/2,    q = sqrt((sig_xx - sig_yy)^2 + 4 sig_xy^2)
//     in space        p = -tr(sigma)/3,            q = sqrt(3 J2)

#include "materials/law/law.hpp"
#include "materials/soiltest/path/history.hpp"

#include <string>
#include <vector>

namespace tremolo::app {

/// p and q, Pa, of the rows of a history.
struct Invariants {
  std::vector<double> p;
  std::vector<double> q;
};

Invariants invariants(const materials::Law& law, const soiltest::History& history);

/// A line from p = 0 on.
struct StressLine {
  std::string name; ///< critical_state, bounding, dilation, phase_transformation, failure
  std::vector<double> p;
  std::vector<double> q;
};

/// The lines that the law has, up to a pressure.
std::vector<StressLine> stress_lines(const materials::Law& law, double largest_p);

} // namespace tremolo::app
