#include "motion/plausible.hpp"
#include "motion/read/read.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void record_is_plausible(const Case& scene, Findings& findings) {
  for (const auto& [file, path] : scene.records()) {
    motion::Record record = motion::read_record(file->path, file->as);
    for (double& sample : record.samples)
      sample *= file->scale;
    for (const std::string& doubt : motion::doubts(record))
      findings.add(path + ".file", fmt::format("{}: {}", file->path.filename().string(), doubt));
  }
}

} // namespace tremolo::scene
