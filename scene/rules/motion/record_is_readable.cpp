#include "motion/read/read.hpp"
#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void record_is_readable(const Case& scene, Findings& findings) {
  const auto* input = std::get_if<MotionFile>(&scene.motion.source);
  if (input == nullptr || !findings.sound("motion.file"))
    return;
  try {
    motion::read_record(input->path, input->as);
  } catch (const motion::RecordError& error) {
    findings.add("motion.file", error.what());
  }
}

} // namespace tremolo::scene
