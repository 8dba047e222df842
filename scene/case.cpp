#include "scene/case.hpp"

namespace tremolo::scene {

std::vector<GivenRecord> MotionInput::records() const {
  std::vector<GivenRecord> records;
  for (const ShakingMotion& shaking : shakings)
    if (const auto* file = std::get_if<MotionFile>(&shaking.source))
      records.push_back({file, shaking.path});
  return records;
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
