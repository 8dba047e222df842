#include "scene/rules/result_names.hpp"
#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void linings_have_names(const Case& scene, Findings& findings) {
  check_result_names("lining", scene.linings, findings);
}

} // namespace tremolo::scene
