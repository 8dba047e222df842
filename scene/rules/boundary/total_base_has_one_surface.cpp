#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void total_base_has_one_surface(const Case& scene, Findings& findings) {
  const double left = scene.boundary.left.surface;
  const double right = scene.boundary.right.surface;
  if (scene.boundary.base.form == BaseForm::total && left != right && findings.sound("boundary") &&
      findings.sound("boundary.left.surface") && findings.sound("boundary.right.surface") &&
      findings.sound("boundary.base.form") && findings.sound("surface.level"))
    findings.add(
        "boundary.base.form",
        fmt::format(
            "form = \"total\" needs one free field, but the surface lies at {} m on the left and at {} m on "
            "the right, and no total field has both; use form = \"blended\" or \"incident\"",
            left, right));
  const bool own = !scene.boundary.left.own_profile.empty() || !scene.boundary.right.own_profile.empty();
  if (scene.boundary.base.form == BaseForm::total && own && findings.sound("boundary.base.form"))
    findings.add("boundary.base.form", "form = \"total\" needs one free field, but a side has layers of its "
                                       "own; use form = \"blended\", \"incident\", "
                                       "or [[profile]] for both sides");
}

} // namespace tremolo::scene
