#include "mpm_domain/spec/limits.hpp"
#include "scene/plan/step/step_limit.hpp"
#include "scene/plan/structures.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

namespace {

/// The largest E, Pa, rounded down, for which waves in the structure are no faster than c (m/s): M = rho c^2.
double stiffness_of(const Structure& structure, double c) {
  const double nu = structure.stiffness->poisson;
  const double young = structure.density * c * c * (1.0 + nu) * (1.0 - 2.0 * nu) / (1.0 - nu);
  const double digit = std::pow(10.0, std::floor(std::log10(young)) - 2.0);
  return std::floor(young / digit) * digit;
}

} // namespace

void structures_leave_the_step(const Case& scene, Findings& findings) {
  if (std::ranges::none_of(scene.structures, [](const Structure& one) { return one.stiffness.has_value(); }))
    return;
  Case rigid = scene;
  for (Structure& structure : rigid.structures)
    structure.stiffness.reset();
  const double of_soil = critical_time_step(rigid, levels(rigid));
  const double h = contact_cell_size(scene);
  for (std::size_t i = 0; i < scene.structures.size(); ++i) {
    const Structure& structure = scene.structures[i];
    if (!structure.stiffness || critical_step(structure, h) > 0.999 * of_soil)
      continue;
    findings.add(
        scene.structures[i].path + ".young",
        fmt::format("'young' = {:g} Pa sets the time step: its critical step is {:.3g} s, that of the soil "
                    "{:.3g} s; {:.3g} Pa would not, nor would rigid = true",
                    structure.stiffness->young, critical_step(structure, h), of_soil,
                    stiffness_of(structure, mpm_domain::largest_courant_number * h / of_soil)));
  }
}

} // namespace tremolo::scene
