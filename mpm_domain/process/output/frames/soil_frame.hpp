#pragma once

// A frame of the soil: its particles, one soil after the other, each in the order of their ids. They are
// worked out while the frame is written, where ranks share the domain each its own.

#include "mpm_domain/domain.hpp"
#include "mpm_domain/particles/all/all_particles.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "results/run_data.hpp"
#include "scene/case.hpp"

#include <cstddef>
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
  /// All ranks make it alike. What it is made from outlives it.
  SoilFrame(const Domain& domain, const Stepper& stepper, const scene::Case& scene);

  /// The quantities that its fields are made from.
  std::vector<ShownQuantity> quantities() const;

  std::size_t particle_count(const AllParticles& all) const;
  /// The fields, which read from here and from all particles.
  std::vector<results::StreamedField> fields(const AllParticles& all) const;

private:
  /// A field, and where its values come from.
  struct Array {
    std::string name;
    std::string unit;
    ShownQuantity quantity;
  };

  const Domain& domain_;
  std::vector<std::int32_t> soil_of_set_; ///< by set, one of soil_names()
  std::vector<Array> arrays_;
};

} // namespace tremolo::mpm_domain
