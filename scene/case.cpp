#include "scene/case.hpp"

#include <algorithm>

namespace tremolo::scene {

std::vector<const MotionInput*> Case::plane_waves() const {
  if (vertical)
    return {&motion, &*vertical};
  return {&motion};
}

bool Case::is_oblique() const {
  return std::ranges::any_of(plane_waves(), [](const MotionInput* wave) { return wave->angle_deg != 0.0; });
}

std::vector<GivenRecord> Case::records() const {
  std::vector<GivenRecord> given;
  for (const MotionInput* wave : plane_waves())
    for (const ShakingMotion& shaking : wave->shakings)
      if (const auto* record = std::get_if<MotionFile>(&shaking.source))
        given.push_back({record, shaking.path});
  return given;
}

std::vector<std::string> StaticStage::undrained_soils() const {
  std::vector<std::string> soils;
  for (const auto& [soil, of_soil] : drainage)
    if (of_soil == StageDrainage::undrained)
      soils.push_back(soil);
  return soils;
}

materials::SoilClock Case::clock() const {
  std::vector<materials::SoilClock::Stage> stages;
  for (const TimedStage& stage : timed)
    stages.push_back({stage.duration, stage.rest ? std::optional(stage.rest->time_factor) : std::nullopt});
  return materials::SoilClock(stages);
}

const TimedStage* Case::fastest_rest() const {
  const TimedStage* fastest = nullptr;
  for (const TimedStage& stage : timed)
    if (stage.rest && (fastest == nullptr || stage.rest->time_factor > fastest->rest->time_factor))
      fastest = &stage;
  return fastest;
}

const TimedStage* Case::rest_after(const ShakingMotion& shaking) const {
  const std::size_t next = shaking.stage + 1;
  return next < timed.size() && timed[next].rest ? &timed[next] : nullptr;
}

} // namespace tremolo::scene
