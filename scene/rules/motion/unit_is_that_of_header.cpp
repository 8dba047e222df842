#include "motion/read/read.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void unit_is_that_of_header(const Case& scene, Findings& findings) {
  for (const auto& [file, path] : scene.records()) {
    if (!file->as.unit)
      continue;
    const motion::Record record = motion::read_record(file->path, file->as);
    if (record.overruled_unit)
      findings.add(
          path + ".unit",
          fmt::format("'unit' = \"{}\", but {} says \"{}\": the motion is taken {:.4g} times as strong as "
                      "its file says",
                      name(record.unit), file->path.filename().string(), name(*record.overruled_unit),
                      in_si(record.unit) / in_si(*record.overruled_unit)));
  }
}

} // namespace tremolo::scene
