#include "app/case/seepage_text.hpp"

#include "mpm_domain/head/seepage_of_ground.hpp"
#include "mpm_domain/process/spec_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <limits>

namespace tremolo::app {

namespace {

/// The least gradient at which water that rises carries the grains of a soil of the domain, gamma'/gamma_w.
double critical_gradient(const mpm_domain::Spec& spec) {
  double least = std::numeric_limits<double>::infinity();
  for (const mpm_domain::Soil& soil : spec.soils)
    if (soil.pores)
      least = std::min(least, materials::buoyant_density(*soil.pores, spec.water->fluid) /
                                  spec.water->fluid.density);
  return least;
}

} // namespace

std::string seepage_text(const scene::Case& scene) {
  if (!scene.water || !scene.water->seepage)
    return {};
  const mpm_domain::Spec spec = mpm_domain::spec_from_case(scene, 1);
  mpm_domain::SeepageFound found;
  try {
    found = mpm_domain::seep(spec).found;
  } catch (const std::exception& none) {
    return fmt::format("\nSeepage\n  {}\n", none.what());
  }
  std::string text =
      fmt::format("\nSeepage\n  {:.4g} m3/s flow through a metre of width, found in {} iterations\n",
                  found.discharge, found.iterations);
  text += found.exit
              ? fmt::format("  the phreatic surface leaves the ground at x = {:.2f} m, y = {:.2f} m; water "
                            "runs out below\n",
                            found.exit->x, found.exit->y)
              : std::string("  no water leaves the ground above the levels at its sides\n");
  const double critical = critical_gradient(spec);
  text += fmt::format(
      "  water rises most steeply at x = {:.2f} m, y = {:.2f} m, with a gradient of {:.3g}; {:.3g} "
      "carries the grains{}\n",
      found.at.x, found.at.y, found.steepest_rise, critical,
      found.steepest_rise >= critical ? ": the ground boils there" : "");
  return text;
}

} // namespace tremolo::app
