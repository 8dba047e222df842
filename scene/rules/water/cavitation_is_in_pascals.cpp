#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void cavitation_is_in_pascals(const Case& scene, Findings& findings) {
  if (!scene.water)
    return;
  constexpr double kilo = 1e3;
  const double pressure = scene.water->fluid.cavitation_pressure;
  if (pressure < 0.0 && pressure > -kilo)
    findings.add("water.cavitation_pressure",
                 fmt::format("'cavitation_pressure' = {:g} Pa lets water carry almost no suction, which sand "
                             "that dilates needs: Pa are meant; {:g} kPa would be {:g}, no suction at all 0",
                             pressure, pressure, kilo * pressure));
}

} // namespace tremolo::scene
