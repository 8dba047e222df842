#include "app/run/domain_ranks.hpp"

#include "app/run/on_path.hpp"
#include "mpm_domain/particles/share_out.hpp"
#include "mpm_domain/process/spec_from_case.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <thread>

#include <unistd.h>

namespace tremolo::app {

void check_ranks(const scene::Case& scene, const DomainRanks& ranks) {
  if (ranks.count == 1)
    return;
#ifndef TREMOLO_MPI
  throw std::runtime_error(
      fmt::format("--ranks {}: this build has no MPI: configure it with -DTREMOLO_MPI=ON", ranks.count));
#endif
  if (on_path("mpirun").empty())
    throw std::runtime_error(
        fmt::format("--ranks {}: there is no mpirun on this machine: install openmpi-bin", ranks.count));
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  if (ranks.count > processors && !ranks.oversubscribe)
    throw std::invalid_argument(fmt::format(
        "--ranks {}: this machine has {} processors, and more ranks than that slow each other down; "
        "--oversubscribe starts them all the same",
        ranks.count, processors));
  try {
    mpm_domain::require_shareable(mpm_domain::spec_from_case(scene, 1));
  } catch (const std::invalid_argument& reason) {
    throw std::invalid_argument(fmt::format("--ranks {}: {}", ranks.count, reason.what()));
  }
}

void start_as_ranks(coupler::ProcessSpec& domain, const DomainRanks& ranks) {
  if (ranks.count == 1)
    return;
  // Threads find their processors by themselves, as those of one process do.
  std::vector<std::string> words{"--bind-to", "none", "-n", std::to_string(ranks.count)};
  if (ranks.oversubscribe)
    words.emplace_back("--oversubscribe");
  if (::geteuid() == 0)
    words.emplace_back("--allow-run-as-root");
  words.push_back(domain.program.string());
  domain.arguments.insert(domain.arguments.begin(), words.begin(), words.end());
  domain.program = on_path("mpirun");
}

} // namespace tremolo::app
