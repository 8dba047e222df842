// Lists the parameters in force for reports.

#include "materials/sand/pdmy03/pdmy03.hpp"
#include "materials/sand/pdmy03/pdmy03_flow.hpp"
#include "materials/sand/pdmy03/pdmy03_parameters.hpp"

#include <fmt/format.h>

#include <numbers>

namespace tremolo::materials {
namespace {

using P = Pdmy03Parameter;
constexpr auto parameter_count = static_cast<std::size_t>(P::count);
static_assert(parameter_count == Pdmy03::origin_count);

constexpr double degrees = 180.0 / std::numbers::pi;

/// Evidence of cyclic strength for an entry of the recommended sets.
enum class Evidence { published, strength, none };

struct Description {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  Evidence evidence = Evidence::published;
};

constexpr std::array<Description, parameter_count> descriptions = {{
    {"density", "kg/m3", "density of the saturated soil"},
    {"shear_modulus", "Pa", "G_r, small-strain shear modulus at the reference pressure", Evidence::strength},
    {"bulk_modulus", "Pa", "B_r, bulk modulus at the reference pressure", Evidence::strength},
    {"friction_deg", "degrees", "friction angle of the cone", Evidence::strength},
    {"phase_transformation_deg", "degrees",
     "phase transformation angle, contraction below and dilation above", Evidence::strength},
    {"contraction_a", "1", "c_a, rate of contraction", Evidence::strength},
    {"contraction_b", "1", "c_b, contraction after dilation", Evidence::none},
    {"contraction_c", "1", "c_c, dependence of contraction on pressure (K_sigma)", Evidence::none},
    {"contraction_d", "1", "c_d, dependence of contraction on the cyclic stress ratio", Evidence::strength},
    {"contraction_e", "1", "c_e, dependence of contraction on static shear (K_alpha)", Evidence::none},
    {"dilation_a", "1", "d_a, rate of dilation", Evidence::none},
    {"dilation_b", "1", "d_b, dependence of dilation on its strain", Evidence::none},
    {"dilation_c", "1", "d_c, dependence of dilation on pressure", Evidence::none},
    {"peak_shear_strain", "1", "octahedral shear strain at the strength, at the reference pressure"},
    {"reference_pressure", "Pa", "p_r, mean effective pressure of G_r and B_r"},
    {"pressure_exponent", "1", "d, stiffness grows with pressure to this power"},
    {"surfaces", "1", "number of yield surfaces"},
    {"liquefaction_1", "1", "share of dilation that widens the perfectly plastic zone"},
    {"liquefaction_2", "1", "share of strain by which the perfectly plastic zone moves"},
    {"atmospheric_pressure", "Pa", "p_a"},
    {"zero_pressure_strength", "Pa", "S0, shear strength at zero mean effective pressure"},
}};

std::array<double, parameter_count> values(const Pdmy03& law) {
  const auto& c = law.contraction;
  const auto& d = law.dilation;
  return {law.elastic.density,
          law.elastic.shear_modulus(),
          law.elastic.bulk_modulus(),
          law.friction * degrees,
          law.phase_transformation * degrees,
          c[0],
          c[1],
          c[2],
          c[3],
          c[4],
          d[0],
          d[1],
          d[2],
          law.peak_shear_strain,
          law.reference_pressure,
          law.pressure_exponent,
          static_cast<double>(law.surfaces),
          law.liquefaction_1,
          law.liquefaction_2,
          law.atmospheric_pressure,
          law.zero_pressure_strength};
}

std::string_view doubt(Evidence evidence) {
  switch (evidence) {
  case Evidence::strength:
    return "; cyclic strength confirms it only together with the others";
  case Evidence::none:
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
                       100.0 * law.relative_density, doubt(descriptions[k].evidence));
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

std::string_view pdmy03_name(Pdmy03Parameter parameter) {
  return descriptions[static_cast<std::size_t>(parameter)].name;
}

std::vector<ParameterValue> parameters(const Pdmy03& law) {
  std::vector<ParameterValue> list;
  const auto all = values(law);
  for (std::size_t k = 0; k < parameter_count; ++k) {
    list.push_back(
        {descriptions[k].name, all[k], descriptions[k].unit, descriptions[k].meaning, origin(law, k)});
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
