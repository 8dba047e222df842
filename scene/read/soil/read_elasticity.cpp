#include "scene/read/read.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::scene {

bool complete(const TableReader& table, Findings& findings, const char* first, const char* second) {
  for (const auto& [have, need] : {std::pair(first, second), std::pair(second, first)})
    if (!table.given(need)) {
      findings.add(table.path(need), fmt::format("missing '{}': '{}' needs it", need, have));
      return false;
    }
  return findings.sound(table.path(first)) && findings.sound(table.path(second));
}

namespace {

constexpr const char* pairs = "'young' and 'poisson', 'vs' and 'vp', or 'vs' and 'poisson'";

/// Elastic soil of two wave speeds.
materials::Elasticity of_wave_speeds(const TableReader& table, Findings& findings, double density) {
  const double vs = table.number("vs");
  const double vp = table.number("vp");
  const double slowest = std::sqrt(4.0 / 3.0) * vs; // bulk modulus 0
  if (vp > slowest)
    return materials::Elasticity::from_wave_speeds(density, vs, vp);
  findings.add(table.path("vp"),
               fmt::format("'vp' = {} is too low for 'vs' = {}, must be > sqrt(4/3) vs = {:.6g} m/s", vp, vs,
                           slowest));
  return {};
}

} // namespace

materials::Elasticity read_elasticity(const TableReader& table, Findings& findings) {
  const double density = table.number("density");
  const bool young = table.given("young");
  const bool poisson = table.given("poisson");
  const bool vs = table.given("vs");
  const bool vp = table.given("vp");
  if (!young && !poisson && !vs && !vp) {
    if (findings.sound(table.path()))
      findings.add(table.path("young"), fmt::format("missing elastic constants: give {}", pairs));
    return {};
  }
  if ((young && (vs || vp)) || (poisson && vp)) {
    const char* const extra = vp ? "vp" : "vs";
    findings.add(table.path(extra), fmt::format("'{}' is one value too many: give {}", extra, pairs));
    return {};
  }
  if (vs && poisson) {
    if (!findings.sound(table.path("vs")) || !findings.sound(table.path("poisson")))
      return {};
    const double nu = table.number("poisson");
    return {density, 2.0 * density * std::pow(table.number("vs"), 2) * (1.0 + nu), nu};
  }
  if (vs && !vp) {
    findings.add(table.path("vp"), "missing 'vp' or 'poisson': 'vs' needs one of them");
    return {};
  }
  if (vp)
    return complete(table, findings, "vs", "vp") ? of_wave_speeds(table, findings, density)
                                                 : materials::Elasticity{};
  return complete(table, findings, "young", "poisson")
             ? materials::Elasticity{density, table.number("young"), table.number("poisson")}
             : materials::Elasticity{};
}

} // namespace tremolo::scene
