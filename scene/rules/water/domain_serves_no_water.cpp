#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void domain_serves_no_water(const Case& scene, Findings& findings) {
  if (scene.water)
    findings.add("water",
                 "the domain has no pore water yet: `tremolo column` computes the free field of this "
                 "case, with model = \"fe\" as coupled soil and water; a run needs a case without "
                 "[water]");
}

} // namespace tremolo::scene
