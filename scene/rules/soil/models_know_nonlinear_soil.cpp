#include "scene/plan/plan.hpp"
#include "scene/plan/sources.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void models_know_nonlinear_soil(const Case& scene, Findings& findings) {
  for (const SourceProcess& source : plan_sources(scene))
    for (std::string& soil : linearised_soils(scene, source))
      findings.add(fmt::format("boundary.{}.model", name(source.serves.front().side)), std::move(soil));
}

} // namespace tremolo::scene
