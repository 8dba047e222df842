#include "scene/rules/result_names.hpp"
#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void structures_have_names(const Case& scene, Findings& findings) {
  std::vector<std::string> names;
  for (const Structure& structure : scene.structures)
    names.push_back(structure.name);
  check_result_names("structure", names, findings);
}

} // namespace tremolo::scene
