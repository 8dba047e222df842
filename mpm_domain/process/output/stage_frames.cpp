#include "mpm_domain/process/output/stage_frames.hpp"

#include "mpm_domain/process/output/frames/soil_frame.hpp"
#include "mpm_domain/process/output/run_output.hpp"
#include "mpm_domain/process/ranks/particles_at_start.hpp"
#include "mpm_domain/transfer/snapshot.hpp"
#include "scene/plan/plan.hpp"
#include "scene/plan/stages/stages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
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
  const std::vector<Particles> found =
      domain.share ? particles_at_start(domain, scene) : std::vector<Particles>{};
  Snapshot snapshot(domain);
  const Stepper stepper(domain, 0.0, [](auto&&...) {});
  std::optional<RunOutput> output;
  if (domain.has_structures_here()) {
    std::filesystem::create_directories(folder);
    const std::vector<std::string> no_sources(domain.boundary.faces().size());
    output.emplace(folder, scene, scene::to_json(scene, scene::plan(scene)), domain,
                   domain.share ? found : domain.sets, snapshot, no_sources);
  }
  snapshot.show(
      {.all = true}, [&] { return SoilFrame(domain, stepper, scene).quantities(); },
      [&] { output->write_before_shaking(stepper); });
  if (output)
    output->abort(reason);
}

} // namespace tremolo::mpm_domain
