#pragma once

// Steady flow of water through ground whose phreatic surface is not known. With the head h = p/gamma + y,
//
//     div(k k_r grad h) = 0,      k_r = 1 where p >= 0, and falls to 1e-3 above (elements.hpp),
//
// on a mesh that stays: water above the surface p = 0 hardly flows (Desai and Li 1983, Adv. Water Resour. 6,
// 47-57; Bathe and Khoshgoftaar 1979, Int. J. Numer. Anal. Meth. Geomech. 3, 13-22). A node of the exit is
// either open, h = y, while water leaves there, or sealed while its pressure is negative. Each iteration
// solves the linear problem of the last k_r and open nodes, and moves half of the way to its heads. It ends
// when
//
//     |dh| < 1e-6 H,   no node of the exit switches,   and what flows in flows out, to 1e-6 of it,
//
// with H the range of the given heads.

#include "seepage/flow_problem.hpp"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

namespace tremolo::seepage {

struct SteadyFlow {
  std::vector<double> heads;      ///< by node, m; of nodes without an element 0
  std::vector<double> inflow;     ///< by node: water that enters the ground there, m2/s; negative: leaves it
  double discharge = 0.0;         ///< all that enters, m2/s
  std::vector<std::size_t> exits; ///< nodes of the exit that water leaves at
  int iterations = 0;
};

/// The iterations have not come to an end.
class NoSteadyFlow : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// @throws std::invalid_argument for a problem without elements or without a given head, or with a
/// permeability or transition that is not positive
/// @throws NoSteadyFlow after 200 iterations
SteadyFlow solve(const FlowProblem& problem);

/// Point at which the phreatic surface meets the exit, m: the highest node with outflow represents the ground
/// half-way to its neighbours, or less of it if its outflow is smaller than that of the next. Empty without
/// exits.
std::optional<Vector> exit_point(const FlowProblem& problem, const SteadyFlow& flow);

} // namespace tremolo::seepage
