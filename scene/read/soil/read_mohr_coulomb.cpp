#include "scene/read/soil/read_soil.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

materials::Law strength_of(const TableReader& table, const materials::Elasticity& elastic) {
  materials::Law law =
      materials::MohrCoulomb{.elastic = elastic, .tension_cutoff = table.optional_number("tension_cutoff")};
  read_fields(law, table);
  return law;
}

struct Bounded {
  const char* key;
  const char* bound_key;
};

/// Residual strength does not exceed peak strength, dilation does not exceed friction, and some strength is
/// left.
void check_strength(const TableReader& table, Findings& findings) {
  for (const auto& [key, bound_key] :
       {Bounded{"cohesion_residual", "cohesion_peak"}, Bounded{"friction_residual_deg", "friction_peak_deg"},
        Bounded{"dilation_residual_deg", "dilation_peak_deg"},
        Bounded{"dilation_peak_deg", "friction_peak_deg"},
        Bounded{"dilation_residual_deg", "friction_residual_deg"}}) {
    const double value = table.number(key);
    const double bound = table.number(bound_key);
    if (value > bound && findings.sound(table.path(key)) && findings.sound(table.path(bound_key)))
      findings.add(table.path(key),
                   fmt::format("'{}' = {:g} is above '{}' = {:g}", key, value, bound_key, bound));
  }
  if (table.number("cohesion_residual") == 0.0 && table.number("friction_residual_deg") == 0.0 &&
      findings.sound(table.path("cohesion_residual")) && findings.sound(table.path("friction_residual_deg")))
    findings.add(
        table.path("friction_residual_deg"),
        "'friction_residual_deg' and 'cohesion_residual' are both 0: the soil would have no strength");
}

} // namespace

Soil read_mohr_coulomb(const NamedTable& soil, double mesh_size, Findings& findings) {
  const auto& table = soil.reader;
  sound_numbers(table, SoilModel::mohr_coulomb, findings);
  const auto elastic = read_elasticity(table, findings);
  check_strength(table, findings);
  materials::Law law = strength_of(table, elastic);
  const auto reference = table.optional_number("reference_size");
  if (const double softening = table.number("softening"); !reference && mesh_size > 0.0 && softening > 0.0)
    findings.add(
        table.path("reference_size"),
        fmt::format("missing 'reference_size', m: the cell size for which 'softening' = {} holds. A shear "
                    "band is a cell or two wide, so without it the work that it takes, and what slides, "
                    "would follow the mesh",
                    softening));
  if (!reference || !(mesh_size > 0.0))
    return {soil.name, law, law, reference, std::nullopt};
  law = materials::for_cell_size(law, mesh_size, *reference);
  return {soil.name, law, law, mesh_size, std::nullopt};
}

} // namespace tremolo::scene
