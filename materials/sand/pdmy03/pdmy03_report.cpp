// Lists the parameters in force for reports.

#include "materials/sand/pdmy03/pdmy03.hpp"
#include "materials/sand/pdmy03/pdmy03_flow.hpp"
#include "materials/sand/pdmy03/pdmy03_parameters.hpp"

#include <fmt/format.h>

#include <numbers>

namespace tremolo::materials {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

std::string_view doubt(Pdmy03Evidence evidence) {
  switch (evidence) {
  case Pdmy03Evidence::strength:
    return "; cyclic strength confirms it only together with the others";
  case Pdmy03Evidence::none:
    return "; cyclic strength does not identify it";
  default:
    return "";
  }
}

std::string origin(const Pdmy03& law, std::size_t k) {
  switch (law.origins[k]) {
  case Pdmy03Origin::given:
    return "given";
  case Pdmy03Origin::table:
    return fmt::format("table D_R {:.0f} %, as known of Khosravifar et al. (2018){}",
                       100.0 * law.relative_density, doubt(pdmy03_rows()[k].evidence));
  case Pdmy03Origin::curve:
    return "from the modulus reduction curve";
  case Pdmy03Origin::fallback:
    break;
  }
  return "default";
}

/// Appends the derived values, and those that the law fixes.
void append_derived(const Pdmy03& law, std::vector<ParameterValue>& list) {
  namespace critical = pdmy03_critical;
  list.push_back({"cone", static_cast<double>(law.cone), "1", "test in which the cone has the friction angle",
                  law.cone_given ? "given" : "default", tremolo::name(law.cone)});
  list.push_back({"failure_ratio", law.ratio[law.surfaces], "1", "M_f, slope of the failure cone in q-p'",
                  "computed from friction and cone"});
  list.push_back({"residual_pressure", law.residual_pressure, "Pa", "p_res, the apex lies at p' = -p_res",
                  "computed: max(2 S0/M_f, 1e-4 p_a)"});
  list.push_back({"void_ratio", critical::void_ratio, "1", "void ratio at zero strain", "fixed"});
  list.push_back(
      {"critical_state_1", critical::intercept, "1", "cs1 of e_cr = cs1 - cs2 (p'/p_a)^cs3", "fixed"});
  list.push_back({"critical_state_2", critical::slope, "1", "cs2", "fixed"});
  list.push_back({"critical_state_3", critical::exponent, "1", "cs3", "fixed"});
}

} // namespace

std::vector<ParameterValue> parameters(const Pdmy03& law) {
  std::vector<ParameterValue> list;
  for (std::size_t k = 0; k < law.origins.size(); ++k) {
    const Pdmy03Row& one = pdmy03_rows()[k];
    list.push_back(report(one.text, one.value(law), origin(law, k)));
  }
  append_derived(law, list);
  return list;
}

std::optional<double> relative_density(const Pdmy03& law) {
  return law.relative_density > 0.0 ? std::optional(law.relative_density) : std::nullopt;
}

std::vector<StrengthLine> strength_lines(const Pdmy03& law) {
  const auto cone = [apex = law.residual_pressure](double slope) {
    return [slope, apex](double p) { return slope * (p + apex); };
  };
  return {{"phase_transformation", cone(law.transformation_ratio)},
          {"failure", cone(law.ratio.at(law.surfaces))}};
}

std::vector<std::string> notes(const Pdmy03& law) {
  std::vector<std::string> list;
  if (law.cone == Pdmy03Cone::triaxial_compression) {
    list.push_back(
        fmt::format("friction_deg = {:.1f} fixes a circular cone in triaxial compression, which is much "
                    "stronger in plane "
                    "strain: the angle mobilised in drained plane-strain compression is 44 to 47 degrees for "
                    "30.3 degrees "
                    "(at 400 to 25 kPa) and 59 degrees for 35.8 (at 50 kPa). The recommended sets are fitted "
                    "to direct simple "
                    "shear with this cone; for an angle meant in the plane take the plane_strain cone",
                    law.friction * degrees));
  }
  if (law.relative_density > 0.0) {
    list.emplace_back(
        "the recommended set reproduces the cyclic strength it was fitted to, which identifies the "
        "moduli, the angles, contraction_a and contraction_d only together, and contraction_b, "
        "contraction_c, contraction_e and dilation_a, _b, _c hardly at all; check them against tests");
  }
  return list;
}

} // namespace tremolo::materials
