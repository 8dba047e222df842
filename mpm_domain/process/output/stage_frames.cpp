#include "mpm_domain/process/output/stage_frames.hpp"

#include "mpm_domain/process/output/run_output.hpp"
#include "mpm_domain/transfer/snapshot.hpp"
#include "scene/plan/plan.hpp"
#include "scene/plan/stages/stages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace tremolo::mpm_domain {

scene::Case case_of_stage(const scene::Case& scene, std::size_t stage) {
  scene::Case then = scene::model_of_stage(scene, stage);
  then.monitors.clear();
  then.lines.clear();
  then.sliding_masses.clear();
  then.sections.clear();
  for (const auto field : {scene::OutputField::displacement, scene::OutputField::stress})
    if (std::ranges::find(then.output.fields, field) == then.output.fields.end())
      then.output.fields.push_back(field);
  return then;
}

std::filesystem::path stage_folder(const std::filesystem::path& run, const scene::Case& scene,
                                   std::size_t stage) {
  std::string name = fmt::format("{} {}", stage + 1, scene::stages(scene)[stage].name);
  std::ranges::replace(name, '/', '-');
  return run / "stages" / name;
}

void write_stage_frame(const std::filesystem::path& folder, const scene::Case& scene, Domain& domain,
                       const std::string& reason) {
  std::filesystem::create_directories(folder);
  const std::vector<std::string> no_sources(domain.boundary.faces().size());
  const Snapshot snapshot(domain);
  RunOutput output(folder, scene, scene::to_json(scene, scene::plan(scene)), domain, domain.sets, snapshot,
                   no_sources);
  output.write_before_shaking(Stepper(domain, 0.0, [](auto&&...) {}));
  output.abort(reason);
}

} // namespace tremolo::mpm_domain
