#include "app/run/case_run.hpp"
#include "app/study/variant.hpp"

#include <algorithm>

namespace tremolo::app {

RunCost run_variant(const Variant& variant, const std::filesystem::path& folder, int threads) {
  RunCost cost;
  for (const auto& process : run_case(*variant.scene, {.folder = folder, .mode = {}, .threads = threads})) {
    (process.name == "domain" ? cost.domain : cost.sources) += process.cpu_seconds;
    cost.wall = std::max(cost.wall, process.wall_seconds);
    cost.updates += process.report.particle_updates;
  }
  return cost;
}

} // namespace tremolo::app
