#include "scene/rules/rules.hpp"

namespace tremolo::scene {

/// By measurement (tests/stability/mpm_domain), FMPM with usl grows from 0.55 h/c_p on at free corners, below
/// the critical step that a fraction is of.
void fmpm_suits_order(const Case& scene, Findings& findings) {
  if (scene.time.transfer == Transfer::fmpm && scene.time.order == StepOrder::usl &&
      findings.sound("time.transfer") && findings.sound("time.order"))
    findings.add("time.order",
                 "transfer = \"fmpm\" needs order = \"musl\" or \"usf\": with \"usl\" it is not "
                 "stable up to the critical step");
}

} // namespace tremolo::scene
