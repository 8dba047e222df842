#pragma once

// A frame of the soil: its particles, one soil after the other, each in the order of their ids.

#include "mpm_domain/domain.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/transfer/snapshot.hpp"
#include "results/run_data.hpp"
#include "scene/case.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::mpm_domain {

/// The names of the soils. Slices of one soil are consecutive and share its name.
std::vector<std::string> soil_names(const Spec& spec);

/// Whether a case requests a field. A field that the case cannot select is written whenever it exists.
bool is_wanted(const scene::Case& scene, std::string_view name);

class SoilFrame {
public:
  SoilFrame(const Domain& domain, const Snapshot& snapshot, const Stepper& stepper, const scene::Case& scene);

  /// They refer to the arrays here.
  std::vector<results::Field> fields() const;

private:
  /// Values of all particles.
  struct Array {
    std::string name;
    std::string unit;
    std::size_t components = 1; ///< a particle
    std::vector<double> values;
  };

  std::vector<std::int32_t> soil_;
  std::vector<Array> arrays_;
};

} // namespace tremolo::mpm_domain
