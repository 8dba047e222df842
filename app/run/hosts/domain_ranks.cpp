#include "app/run/hosts/domain_ranks.hpp"

#include "app/run/hosts/rank_places.hpp"
#include "app/run/hosts/words.hpp"
#include "base/temporary_parent.hpp"
#include "mpm_domain/process/ranks/shared_memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include <unistd.h>

namespace tremolo::app {

namespace {

using scene::StartRanksBy;

/// The launcher of ranks on other machines; empty if all run here.
std::optional<StartRanksBy> start_elsewhere(const scene::Case& scene, bool local) {
  return local || !scene.hosts.domain ? std::nullopt : std::optional(scene.hosts.domain->start);
}

/// The machines of [hosts.domain] that ssh reaches.
std::vector<scene::RankMachine> machines(const scene::Case& scene, bool local) {
  return start_elsewhere(scene, local) == StartRanksBy::ssh ? scene.hosts.domain->machines
                                                            : std::vector<scene::RankMachine>{};
}

int processors() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::vector<int> places(const scene::Case& scene, const DomainRanks& ranks, bool local) {
  return rank_places(ranks.count, machines(scene, local), processors(), ranks.oversubscribe);
}

std::string this_machine() {
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  return name.data();
}

void require_other_machines(const scene::Case& scene) {
  for (const auto& machine : scene.hosts.domain->machines)
    if (machine.name == this_machine() || machine.name == "localhost")
      throw std::invalid_argument(fmt::format("[hosts.domain] names this machine, '{}': it takes the first "
                                              "ranks in any case; name the others alone",
                                              machine.name));
}

/// Slurm gives mpirun the nodes. Rank 0 comes to the first one, and the hub's socket is on this machine.
void require_job(const DomainRanks& ranks) {
  if (environment("SLURM_JOB_ID").empty())
    throw std::runtime_error(
        "[hosts.domain] has start = \"slurm\", but this is not a Slurm job: `tremolo sbatch "
        "CASE --ranks N` writes one");
  if (environment("SLURM_NODEID") != "0")
    throw std::runtime_error(
        "[hosts.domain] has start = \"slurm\": rank 0 comes to the first node of the job, and "
        "this is another machine: run the script of `tremolo sbatch CASE --ranks N`");
  const int tasks = std::atoi(environment("SLURM_NTASKS").c_str());
  if (tasks > 0 && ranks.count > tasks && !ranks.oversubscribe)
    throw std::invalid_argument(fmt::format(
        "--ranks {}: the job has {} tasks: submit it with --ntasks={}, or --oversubscribe starts them "
        "all the same",
        ranks.count, tasks, ranks.count));
}

/// The words that let mpirun find the machines.
Words placed(const scene::Case& scene, const DomainRanks& ranks, bool local, double connect_deadline) {
  const auto start = start_elsewhere(scene, local);
  if (start == StartRanksBy::slurm)
    return {};
  // Without this, mpirun would use the nodes of a Slurm job.
  Words words{"--mca", "ras", "^slurm"};
  if (!start)
    return joined(words, {"--mca", "plm", "isolated"});
  const auto& others = scene.hosts.domain->machines;
  const auto count = places(scene, ranks, local);
  std::string hosts = fmt::format("localhost:{}", count.front());
  for (std::size_t m = 0; m < others.size(); ++m)
    if (count[m + 1] > 0)
      hosts += fmt::format(",{}:{}", others[m].name, count[m + 1]);
  // It asks nobody anything, and each machine is reached from this one.
  return joined(words,
                {"--mca", "plm", "rsh", "--mca", "plm_rsh_no_tree_spawn", "1", "--mca", "plm_rsh_agent",
                 fmt::format("{} -n -x -o BatchMode=yes -o ConnectTimeout={} --", found_on_path("ssh"),
                             std::llround(std::ceil(connect_deadline))),
                 "--host", hosts});
}

} // namespace

void check_ranks(const scene::Case& scene, const DomainRanks& ranks, bool local) {
  if (ranks.count == 1)
    return;
#ifndef TREMOLO_MPI
  throw std::runtime_error(
      fmt::format("--ranks {}: this build has no MPI: configure it with -DTREMOLO_MPI=ON", ranks.count));
#endif
  if (on_path("mpirun").empty())
    throw std::runtime_error(
        fmt::format("--ranks {}: there is no mpirun on this machine: install openmpi-bin", ranks.count));
  const auto start = start_elsewhere(scene, local);
  if (!start && ranks.count > processors() && !ranks.oversubscribe)
    throw std::invalid_argument(fmt::format(
        "--ranks {}: this machine has {} processors, and more ranks than that slow each other down; "
        "--oversubscribe starts them all the same",
        ranks.count, processors()));
  if (start == StartRanksBy::ssh) {
    require_other_machines(scene);
    places(scene, ranks, local);
    found_on_path("ssh");
  }
  if (start == StartRanksBy::slurm)
    require_job(ranks);
}

int ranks_here(const scene::Case& scene, const DomainRanks& ranks, bool local) {
  return start_elsewhere(scene, local) == StartRanksBy::ssh ? places(scene, ranks, local).front()
                                                            : ranks.count;
}

std::string ranks_text(const scene::Case& scene, const DomainRanks& ranks, bool local) {
  const auto start = start_elsewhere(scene, local);
  if (start == StartRanksBy::slurm)
    return fmt::format("as {} ranks on the nodes of the job", ranks.count);
  if (!start)
    return fmt::format("as {} ranks", ranks.count);
  const auto count = places(scene, ranks, local);
  std::string text = fmt::format("as {} ranks, {} here", ranks.count, count.front());
  for (std::size_t m = 1; m < count.size(); ++m)
    if (count[m] > 0)
      text += fmt::format(", {} on {}", count[m], scene.hosts.domain->machines[m - 1].name);
  return text;
}

std::filesystem::path shared_memory_parent() {
  const std::filesystem::path memory = "/dev/shm";
  return ::access(memory.c_str(), W_OK | X_OK) == 0 ? memory : temporary_parent();
}

void start_as_ranks(coupler::ProcessSpec& domain, const scene::Case& scene, const DomainRanks& ranks,
                    bool local, const std::filesystem::path& folder, double connect_deadline) {
  if (ranks.count == 1)
    return;
  // Threads find their processors by themselves, as those of one process do.
  Words words{"--bind-to", "none", "-n", std::to_string(ranks.count)};
  if (ranks.oversubscribe)
    words = joined(words, {"--oversubscribe", "--mca", "mpi_yield_when_idle", "1"});
  if (::geteuid() == 0)
    words.emplace_back("--allow-run-as-root");
  words = joined(words, placed(scene, ranks, local, connect_deadline));
  if (start_elsewhere(scene, local))
    words = joined(words, words_of(scene.hosts.domain->options));
  words = joined(words, {domain.program.string(), "--ranks", std::to_string(ranks.count)});
  domain.arguments.insert(domain.arguments.begin(), words.begin(), words.end());
  domain.program = on_path("mpirun");
  // Ranks have no files to close: they need no time before they are killed. Those of a machine that is cut
  // off end within half a minute. What the user sets on the command line counts more.
  domain.environment = {"OMPI_MCA_odls_base_sigkill_timeout=0", "OMPI_MCA_oob_tcp_keepalive_time=5",
                        "OMPI_MCA_oob_tcp_keepalive_intvl=5", "OMPI_MCA_oob_tcp_keepalive_probes=5"};
  domain.environment.push_back(fmt::format("{}={}", mpm_domain::shared_memory_variable, folder.string()));
  // Slurm hands the environment to all nodes, where that folder is not.
  if (start_elsewhere(scene, local) != StartRanksBy::slurm)
    domain.environment.push_back(fmt::format("TMPDIR={}", folder.string()));
}

} // namespace tremolo::app
