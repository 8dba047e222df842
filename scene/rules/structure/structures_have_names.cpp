#include "scene/rules/result_names.hpp"
#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void structures_have_names(const Case& scene, Findings& findings) {
  check_result_names("structure", scene.structures, findings);
}

} // namespace tremolo::scene
