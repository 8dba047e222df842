#include "scene/rules/result_names.hpp"
#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void sections_have_names(const Case& scene, Findings& findings) {
  check_result_names("section", scene.sections, findings);
}

} // namespace tremolo::scene
