#include "motion/read/read.hpp"
#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void record_is_readable(const Case& scene, Findings& findings) {
  for (const auto& [file, path] : scene.records()) {
    if (!findings.sound(path + ".file"))
      continue;
    try {
      motion::read_record(file->path, file->as);
    } catch (const motion::RecordError& error) {
      findings.add(path + ".file", error.what());
    }
  }
}

} // namespace tremolo::scene
