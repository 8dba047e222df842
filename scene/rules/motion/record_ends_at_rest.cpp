#include "motion/measures.hpp"
#include "motion/read/read.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void record_ends_at_rest(const Case& scene, Findings& findings) {
  for (const auto& [file, path] : scene.records())
    if (const auto residual =
            motion::residual_warning(motion::measures(motion::read_record(file->path, file->as))))
      findings.add(path + ".file", fmt::format("{}: {}", file->path.filename().string(), *residual));
}

} // namespace tremolo::scene
