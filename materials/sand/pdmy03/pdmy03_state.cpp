#include "materials/sand/pdmy03/pdmy03_state.hpp"

#include <fmt/format.h>

namespace tremolo::materials {
namespace {

/// Names that stay where they are, for the variables that view them.
struct Table {
  std::vector<std::string> names;
  std::vector<StateVariable> variables;

  Table() {
    constexpr std::size_t size = pdmy03_state_size(most_pdmy03_surfaces);
    names.reserve(size);
    variables = {
        {"rotation", "rad", "rotation of the material since the start", 0.0},
        {"active_surface", "1", "yield surface the stress is on, 0 inside all of them", 0.0},
        {"dilation_zone", "1", "-1 never dilated, 0 contracting again, 1 perfectly plastic, 2 dilating",
         pdmy03_zone::never_reached},
        {"zone_size", "1", "octahedral shear strain to cross the perfectly plastic zone", 0.0},
        {"dilation_strain", "1", "octahedral shear strain since the present dilation began", 0.0},
        {"dilation_strain_total", "1", "octahedral shear strain under dilation, weighted by damage", 0.0},
        {"zone_translation", "1", "octahedral shear strain by which the zone has moved", 0.0},
        {"damage", "1", "fourth root of the relative loss of pressure when dilation began", 0.0},
        {"largest_pressure", "Pa", "largest mean effective pressure so far", 0.0},
        {"gap", "1", "volumetric expansion beyond zero effective stress", 0.0},
        {"volume_strain", "1", "volumetric strain since zero stress", 0.0},
        {"initial_height", "Pa", "initial mean effective pressure plus residual pressure", 0.0, true},
        {"initial_shear_ratio", "1", "initial shear stress on the horizontal plane over initial_height", 0.0,
         true}};
    names3("strain_deviator", "1", "strain deviator since zero stress");
    names3("zone_pivot", "1", "strain deviator where dilation was last in progress");
    names3("zone_centre", "1", "strain deviator at the centre of the perfectly plastic zone");
    names3("zone_direction", "1", "strain increment with which dilation last began");
    names3("active_centre", "1", "centre of the active surface over distance from the apex");
    for (std::size_t i = pdmy03_fixed_size; i < size; ++i) {
      names.push_back(fmt::format("centres_{:02}", i - pdmy03_fixed_size + 1));
      variables.push_back(
          {names.back(), "1", "two single-precision components of the centres of surfaces", 0.0, true});
    }
  }

  void names3(std::string_view name, std::string_view unit, std::string_view meaning) {
    for (const char* component : {"a", "b", "c"}) {
      names.push_back(fmt::format("{}_{}", name, component));
      variables.push_back({names.back(), unit, meaning, 0.0, true});
    }
  }
};

} // namespace

Traits traits(const Pdmy03& /*law*/) {
  return {.name = "pdmy03",
          .response = Response::cyclic_mobility,
          .follows_pressure = true,
          .remembers_initial_stress = true};
}

std::span<const StateVariable> state_variables(const Pdmy03& law) {
  static const Table table;
  return std::span<const StateVariable>(table.variables).first(pdmy03_state_size(law.surfaces));
}

} // namespace tremolo::materials
