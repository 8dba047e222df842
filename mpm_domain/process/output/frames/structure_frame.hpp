#pragma once

// A frame of the elastic structures: their particles, structure after structure, each in the order of their
// ids. Where ranks share the domain, the first has them all.

#include "mpm_domain/domain.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "results/run_data.hpp"
#include "scene/case.hpp"

#include <cstdint>
#include <vector>

namespace tremolo::mpm_domain {

struct StructureFrame {
  StructureFrame(const Domain& domain, const Stepper& stepper);

  /// The fields that the case requests, which refer to the arrays; none without an elastic structure.
  std::vector<results::Field> fields(const scene::Case& scene) const;

  std::vector<double> position, size, displacement;
  std::vector<double> stress; ///< below a water table that beyond the pressure of water at rest
  std::vector<std::int32_t> body;
};

} // namespace tremolo::mpm_domain
