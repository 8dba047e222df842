#include "app/run/hosts/hosts.hpp"

#include "app/run/hosts/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

/// Quotes a text as one word for a shell.
std::string quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// The command for the shell on the other machine.
std::string shell_line(const scene::Host& host, const std::string& participant, const fs::path& keys,
                       const std::string& endpoint, const std::string& run) {
  return fmt::format("{} join {} --role {} --keys {} --run {}", host.command, quoted(endpoint),
                     quoted(participant), quoted(host.keys.empty() ? keys.string() : host.keys), run);
}

coupler::Elsewhere through_ssh(const scene::Host& host, const std::string& participant, const fs::path& keys,
                               double connect_deadline) {
  // It asks nobody anything, and reads nothing that is meant for us.
  const Words ssh = joined({found_on_path("ssh"), "-n", "-T", "-o", "BatchMode=yes", "-o",
                            fmt::format("ConnectTimeout={}", std::llround(std::ceil(connect_deadline)))},
                           words_of(host.options));
  return {"ssh to " + host.address, [=](const std::string& endpoint, const std::string& run) {
            return joined(ssh, {"--", host.address, shell_line(host, participant, keys, endpoint, run)});
          }};
}

coupler::Elsewhere through_slurm(const scene::Host& host, const std::string& participant,
                                 const fs::path& keys, int number) {
  if (environment("SLURM_JOB_ID").empty())
    throw std::runtime_error(
        "[hosts] has start = \"slurm\", but this is not a Slurm job: `tremolo sbatch CASE` "
        "writes one");
  const auto nodes = environment("SLURM_JOB_NUM_NODES");
  const int node = number % std::max(1, std::atoi(nodes.c_str()));
  // --overlap: a step shall not wait for the processors of another one of the same run.
  const Words srun =
      joined({found_on_path("srun"), "--nodes=1", "--ntasks=1", "--overlap", "--input=none",
              fmt::format("--relative={}", node), fmt::format("--job-name=tremolo-{}", participant)},
             words_of(host.options));
  return {"srun", [=](const std::string& endpoint, const std::string& run) {
            return joined(srun, {"sh", "-c", shell_line(host, participant, keys, endpoint, run)});
          }};
}

} // namespace

coupler::Elsewhere elsewhere(const scene::Host& host, const std::string& participant, const fs::path& keys,
                             double connect_deadline, int number) {
  const auto absolute = keys.empty() ? keys : fs::absolute(keys); // without, the hub does not listen
  switch (host.start) {
  case scene::StartBy::ssh:
    return through_ssh(host, participant, absolute, connect_deadline);
  case scene::StartBy::slurm:
    return through_slurm(host, participant, absolute, number);
  case scene::StartBy::join:
    break;
  }
  return {"", [=](const std::string& endpoint, const std::string&) {
            return Words{"tremolo", "join", endpoint, "--role", participant, "--keys", keys.string()};
          }};
}

} // namespace tremolo::app
