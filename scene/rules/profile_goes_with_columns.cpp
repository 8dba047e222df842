#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void profile_goes_with_columns(const Case& scene, Findings& findings) {
  if (scene.profile.empty())
    return;
  const auto check = [&](SourceModel model, const char* path) {
    if (model == SourceModel::wave && findings.sound(path))
      findings.add(
          path,
          "model = \"wave\" is a homogeneous half-space and cannot take the layers of [[profile]]; use model "
          "= \"column\" or remove [[profile]]");
  };
  check(scene.boundary.left.model, "boundary.left.model");
  check(scene.boundary.right.model, "boundary.right.model");
  check(scene.boundary.base.model, "boundary.base.model");
}

} // namespace tremolo::scene
