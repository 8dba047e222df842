#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::scene {

void props_bear_their_prestress(const Case& scene, Findings& findings) {
  for (const Prop& prop : scene.props) {
    if (!prop.prestress)
      continue;
    const double force = *prop.prestress;
    const std::string path = prop.path + ".prestress";
    if ((prop.bears == mpm_domain::Bears::tension && force < 0.0) ||
        (prop.bears == mpm_domain::Bears::compression && force > 0.0))
      findings.add(path,
                   fmt::format("'prestress' = {:g} N/m is {}, but the prop '{}' bears {} alone: tension "
                               "is positive",
                               force, force > 0.0 ? "tension" : "compression", prop.name, name(prop.bears)));
    if (prop.yield && std::abs(force) > *prop.yield)
      findings.add(path,
                   fmt::format("'prestress' = {:g} N/m is over 'yield' = {:g} N/m", force, *prop.yield));
  }
}

} // namespace tremolo::scene
