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

materials::Elasticity read_elasticity(const TableReader& table, Findings& findings) {
  const double density = table.number("density");
  const bool moduli = table.given("young") || table.given("poisson");
  const bool speeds = table.given("vs") || table.given("vp");
  if (moduli && speeds) {
    const auto extra = table.given("vs") ? "vs" : "vp";
    findings.add(table.path(extra),
                 fmt::format("'{}' is one value too many: give either 'young' and 'poisson' or 'vs' and "
                             "'vp'",
                             extra));
    return {};
  }
  if (moduli)
    return complete(table, findings, "young", "poisson")
               ? materials::Elasticity{density, table.number("young"), table.number("poisson")}
               : materials::Elasticity{};
  if (!speeds) {
    if (findings.sound(table.path()))
      findings.add(table.path("young"),
                   "missing elastic constants: give either 'young' and 'poisson' or 'vs' and 'vp'");
    return {};
  }
  if (!complete(table, findings, "vs", "vp"))
    return {};
  const double vs = table.number("vs");
  const double vp = table.number("vp");
  const double slowest = std::sqrt(4.0 / 3.0) * vs; // bulk modulus 0
  if (!(vp > slowest)) {
    findings.add(table.path("vp"),
                 fmt::format("'vp' = {} is too low for 'vs' = {}, must be > sqrt(4/3) vs = {:.6g} m/s", vp,
                             vs, slowest));
    return {};
  }
  return materials::Elasticity::from_wave_speeds(density, vs, vp);
}

} // namespace tremolo::scene
