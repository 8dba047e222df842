#include "scene/rules/result_names.hpp"
#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void props_have_names(const Case& scene, Findings& findings) {
  check_result_names("prop", scene.props, findings);
}

} // namespace tremolo::scene
