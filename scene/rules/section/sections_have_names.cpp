#include "scene/rules/result_names.hpp"
#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void sections_have_names(const Case& scene, Findings& findings) {
  std::vector<std::string> names;
  for (const Section& section : scene.sections)
    names.push_back(section.name);
  check_result_names("section", names, findings);
}

} // namespace tremolo::scene
