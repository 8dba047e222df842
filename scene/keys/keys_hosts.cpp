#include "scene/keys/keys_hosts.hpp"

#include "scene/choices.hpp"
#include "scene/keys/soil/keys_elastic.hpp"

namespace tremolo::scene {

namespace {

Table host(std::string_view name, std::string_view meaning) {
  Key start = choice<StartBy>(
      "start",
      "Who starts it. `ssh`: `tremolo run`, through ssh to `host`. `slurm`: `tremolo run`, with `srun` "
      "in the job that it runs in. `join`: you, on its machine, with the `tremolo join` that `tremolo "
      "run` prints.");
  start.required = true;
  return {
      .name = name,
      .meaning = meaning,
      .keys = {start,
               {.name = "host",
                .type = Type::text,
                .meaning = "Where ssh goes: `node2`, `user@node2`, or a name of `~/.ssh/config`.",
                .required = true,
                .when = {"start", {scene::name(StartBy::ssh)}}},
               {.name = "options",
                .type = Type::text,
                .meaning = "Options of `ssh` or `srun`, separated by blanks.",
                .otherwise = "none",
                .when = {"start", {scene::name(StartBy::ssh), scene::name(StartBy::slurm)}}},
               {.name = "command",
                .type = Type::text,
                .meaning = "The `tremolo` there, as a shell there reads it: a name, a path, or more, such "
                           "as `module load tremolo; tremolo`.",
                .fallback = "tremolo",
                .when = {"start", {scene::name(StartBy::ssh), scene::name(StartBy::slurm)}}},
               {.name = "keys",
                .type = Type::text,
                .meaning = "Folder of its CURVE keys there; relative to where ssh or srun begins.",
                .otherwise = "the folder that `tremolo run --keys` names here",
                .when = {"start", {scene::name(StartBy::ssh), scene::name(StartBy::slurm)}}}}};
}

Table rank_hosts() {
  Key start = choice<StartRanksBy>(
      "start", "Who starts the ranks of `tremolo run --ranks N`. `ssh`: mpirun, through ssh to the other "
               "machines. `slurm`: mpirun, on the nodes of the Slurm job that the run is.");
  start.required = true;
  return {
      .name = "hosts.domain",
      .meaning = "Where ranks of the domain run, see docs/ranks.md; how many they are, `--ranks` says. Rank "
                 "0 and those after it run where `tremolo run` is called, the others on these machines.",
      .keys = {start,
               {.name = "machines",
                .type = Type::texts,
                .meaning = "Machines beside that of the run, as ssh knows them. `node2:8` takes at most "
                           "eight ranks; `node2` takes as many as the machine of the run has processors.",
                .required = true,
                .when = {"start", {scene::name(StartRanksBy::ssh)}}},
               {.name = "options",
                .type = Type::text,
                .meaning = "Options of mpirun, separated by blanks, such as `--mca btl_tcp_if_include ib0`.",
                .otherwise = "none"}}};
}

} // namespace

std::vector<Table> hosts_keys() {
  return {
      {.name = "hosts",
       .meaning = "Which free fields are computed on other machines, and where ranks of the domain run, see "
                  "docs/cluster.md. The domain itself, or its rank 0, runs where `tremolo run` is called.",
       .keys = {{.name = "endpoint",
                 .type = Type::text,
                 .meaning = "Where processes on other machines reach this run: `tcp://ADDRESS:PORT`. "
                            "ADDRESS is a number of this machine, the name of one of its network "
                            "interfaces, or `*`, all of them; others are then given this machine's name. "
                            "PORT may be `*`, any free one.",
                 .otherwise = "needed where a side is placed"},
                {.name = "slurm_options",
                 .type = Type::text,
                 .meaning = "Options of the job that `tremolo sbatch` writes, separated by blanks, such as "
                            "`--partition=short --time=01:00:00`.",
                 .otherwise = "none"}}},
      host("hosts.left", "Where the free field of the left side is computed."),
      host("hosts.right", "Where that of the right side is."),
      host("hosts.base", "Where that of the base is."),
      rank_hosts()};
}

} // namespace tremolo::scene
