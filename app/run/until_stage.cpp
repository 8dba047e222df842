#include "app/run/until_stage.hpp"

#include "coupler/wire/handshake/messages.hpp"
#include "mpm_domain/fields/stages_over.hpp"
#include "results/checkpoint_file.hpp"
#include "scene/plan/stages/stages.hpp"
#include "scene/text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace tremolo::app {

namespace {

/// The place of a stage among all of them.
std::size_t stage_named(const std::string& until, const std::vector<scene::PlannedStage>& stages) {
  const auto stage = std::ranges::find(stages, until, &scene::PlannedStage::name);
  if (stage != stages.end())
    return static_cast<std::size_t>(std::distance(stages.begin(), stage));
  std::vector<std::string_view> names;
  names.reserve(stages.size());
  for (const scene::PlannedStage& one : stages)
    names.push_back(one.name);
  throw std::invalid_argument(fmt::format("--until {}: the case has no stage of this name, {}", until,
                                          scene::suggestion(until, names)));
}

/// Number of completed stages when a checkpoint was made.
std::size_t stages_over(const scene::Case& scene, const coupler::CheckpointSet& set) {
  const results::CheckpointReader domain(set.folder / "domain.h5",
                                         {"domain", coupler::text_crc(set.run.case_text), set.step});
  const auto at_rest = static_cast<std::size_t>(domain.integers(mpm_domain::stages_over_name).at(0));
  const auto timed = std::ranges::count_if(scene.timed, [&](const scene::TimedStage& stage) {
    return set.time >= scene.clock().simulated_time(stage.end());
  });
  return at_rest + static_cast<std::size_t>(timed);
}

} // namespace

void add_until_option(Command& command, std::string& until) {
  command.add_option("--until", until,
                     "Stage to end after, by its name; `tremolo resume` goes on from there");
}

void check_until(const scene::Case& scene, const std::string& until) {
  if (until.empty())
    return;
  const std::vector<scene::PlannedStage> stages = scene::stages(scene);
  if (stage_named(until, stages) + 1 < stages.size() && scene.checkpoints.keep == 0)
    throw std::invalid_argument(fmt::format("--until {}: the case keeps no checkpoint to go on from: give "
                                            "[checkpoint] 'keep' at least 1",
                                            until));
}

void check_until(const scene::Case& scene, const std::string& until, const coupler::CheckpointSet& set) {
  check_until(scene, until);
  if (until.empty())
    return;
  const std::vector<scene::PlannedStage> stages = scene::stages(scene);
  const std::size_t over = stages_over(scene, set);
  if (stage_named(until, stages) >= over)
    return;
  std::string left;
  for (std::size_t stage = over; stage < stages.size(); ++stage)
    left += fmt::format("{}'{}'", left.empty() ? "" : ", ", stages[stage].name);
  throw std::invalid_argument(
      fmt::format("--until {}: this stage was over at the checkpoint of step {}, {:.6g} s, "
                  "from which the run goes on; still to come: {}",
                  until, set.step, set.time, left));
}

} // namespace tremolo::app
