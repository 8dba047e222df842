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

struct SoilFrame {
  /// @param has_water  whether there is a water table, without which no field of the pore water is written
  SoilFrame(const Domain& domain, const Snapshot& snapshot, const Stepper& stepper, bool has_water);

  /// The fields that the case requests; they refer to the arrays.
  std::vector<results::Field> fields(const scene::Case& scene) const;

  /// A field that particles carry.
  struct Carried {
    std::string name;
    std::string unit;
    std::vector<std::string> components; ///< names of particle fields
    std::vector<double> values;
  };
  /// Fields that follow from the pore water; 0 where there is none.
  struct Water {
    std::vector<double> pressure, excess, ratio, flux;
  };

  std::vector<double> position, displacement, acceleration;
  std::vector<double> size; ///< on a graded mesh alone
  std::vector<std::int32_t> soil;
  std::vector<Carried> carried; ///< by the table of fields
  Water water;
  std::vector<materials::StateVariable> variables; ///< of all soils, each name once
  std::vector<std::vector<double>> states; ///< one array a variable; 0 where a soil has no such variable
};

} // namespace tremolo::mpm_domain
