#pragma once

#include "base/vector.hpp"

#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// Forces that pass through a section of a structure or of a lining, per metre out of plane.
struct SectionForces {
  double axial = 0.0;  ///< N, tension positive, N/m
  double shear = 0.0;  ///< Q, N/m
  double moment = 0.0; ///< M, N; positive where it stretches the right-hand side of the way along the axis
};

/// A straight cut from one surface of a structure to the other, at the start, m. On the way from one end to
/// the other the axis runs to the left: M stretches the far end.
struct CutLine {
  Vector from;
  Vector to;
};

/// Cuts through an elastic structure, whose forces are wanted.
struct Section {
  std::string name;
  std::string structure; ///< its name
  std::vector<CutLine> cuts;
};

} // namespace tremolo::mpm_domain
