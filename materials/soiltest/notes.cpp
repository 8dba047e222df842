#include "materials/soiltest/notes.hpp"

#include "materials/soiltest/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace tremolo::soiltest {
namespace {

constexpr double rounding = 1e-6;       // of the largest initial stress
constexpr double strongest_sand = 40.0; // degrees of friction that sand can mobilise at rest

struct Component {
  std::string_view name;
  double wanted; ///< Pa
  double held;
};

/// A note if the law changed the initial stress; the out-of-plane stress is not given but computed by laws of
/// plane strain.
void add_changed_stress(std::vector<std::string>& notes, double level, const materials::PointStress& wanted,
                        const materials::PointTest& point) {
  const materials::PointStress& held = point.stress();
  const std::array<Component, 4> components = {{{"sig_xx", wanted.xx, held.xx},
                                                {"sig_yy", wanted.yy, held.yy},
                                                {"sig_zz", wanted.zz, held.zz},
                                                {"sig_xy", wanted.xy, held.xy}}};
  std::string list;
  for (const Component& one : components) {
    const bool made = one.name == "sig_zz" && !traits(point.law()).three_dimensional;
    if (!made && std::abs(one.held - one.wanted) > rounding * level) {
      list += fmt::format("{}{} = {:.4g} Pa becomes {:.4g} Pa", list.empty() ? "" : ", ", one.name,
                          one.wanted, one.held);
    }
  }
  if (!list.empty())
    notes.push_back(fmt::format("the law cannot hold the initial stress: {}", list));
}

/// PM4Sand reports the stress that it was given and keeps the part that its surfaces cannot hold apart.
void add_offset(std::vector<std::string>& notes, double level, const materials::PointTest& point) {
  const auto variables = state_variables(point.law());
  std::string list;
  for (std::size_t k = 0; k < variables.size(); ++k) {
    const std::string_view name = variables[k].name;
    if (name.starts_with("offset_") && std::abs(point.state()[k]) > rounding * level)
      list += fmt::format("{}{} = {:.4g} Pa", list.empty() ? "" : ", ", name, point.state()[k]);
  }
  if (!list.empty()) {
    notes.push_back(fmt::format("the law cannot hold the initial stress: it keeps {} of it (compression "
                                "positive) apart for the whole test",
                                list));
  }
}

/// The cone of a sand may hold in space what no sand holds in the plane: sin phi = (s1 - s3)/(s1 + s3).
void add_mobilised_friction(std::vector<std::string>& notes, const materials::Law& law,
                            const materials::PointStress& wanted) {
  if (!materials::traits(law).follows_pressure)
    return;
  const double radius = std::hypot(0.5 * (wanted.xx - wanted.yy), wanted.xy);
  const double centre = -0.5 * (wanted.xx + wanted.yy);
  const double degrees = std::asin(std::min(radius / centre, 1.0)) * 180.0 / std::numbers::pi;
  if (degrees > strongest_sand)
    notes.push_back(fmt::format("the initial stress mobilises {:.3g} degrees of friction before the test "
                                "begins, where sand at rest has {:g} at most: what follows means little; "
                                "change k0 or shear_bias",
                                degrees, strongest_sand));
}

} // namespace

bool has_pore_pressure_ratio(const materials::Law& law, const SoilTest& test) {
  return test.drainage == Drainage::drained || !materials::traits(law).total_stress;
}

std::vector<std::string> notes(const materials::Law& law, const SoilTest& test) {
  std::vector<std::string> notes;
  const materials::PointStress wanted = stress_at_start(test);
  materials::PointTest point(law, wanted);
  point.apply({}); // a step of no strain, in which a law returns to its strength
  const double level = std::max({std::abs(wanted.xx), std::abs(wanted.yy), std::abs(wanted.xy)});
  add_mobilised_friction(notes, law, wanted);
  add_changed_stress(notes, level, wanted, point);
  add_offset(notes, level, point);
  if (!has_pore_pressure_ratio(law, test)) {
    notes.push_back(fmt::format("{} is a law in total stress, whose strength does not follow the effective "
                                "stress: r_u has no meaning and is left out",
                                materials::name(law)));
  }
  return notes;
}

} // namespace tremolo::soiltest
