#include "scene/rules/result_names.hpp"
#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void linings_have_names(const Case& scene, Findings& findings) {
  std::vector<std::string> names;
  for (const Lining& lining : scene.linings)
    names.push_back(lining.name);
  check_result_names("lining", names, findings);
}

} // namespace tremolo::scene
