#include "scene/rules/rules.hpp"

#include <array>

namespace tremolo::scene {

std::span<const Rule> rules() {
  static constexpr std::array<Rule, 14> all = {
      record_is_readable,        strength_is_ordered,        box_fits_lattice,
      regions_are_simple,        regions_lie_in_mesh,        regions_are_apart,
      soil_reaches_boundaries,   total_base_has_one_surface, columns_are_shaken_vertically,
      profile_goes_with_columns, layer_damping_has_model,    reference_lies_in_halfspace,
      time_step_is_stable,       monitors_lie_in_soil,
  };
  return all;
}

} // namespace tremolo::scene
