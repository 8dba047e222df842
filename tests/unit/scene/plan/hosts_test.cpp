// [hosts]: where the processes of a run are placed, and what is refused.

#include "scene/plan/hosts.hpp"

#include "tests/unit/scene/case_text.hpp"
#include "scene/text/files.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace tremolo::scene::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string hosts(const std::string& sides, const std::string& endpoint = "tcp://10.0.0.1:5555") {
  return plus("[hosts]\nendpoint = \"" + endpoint + "\"\n" + sides + "\n");
}

Case parsed(const std::string& text) {
  return parse(text, "case.toml", ".");
}

TEST(Hosts, WithoutTheTableAllProcessesRunHere) {
  const auto scene = parsed(std::string(flat_case));
  for (const auto& source : plan(scene).sources)
    EXPECT_EQ(host_of(scene, source), nullptr);
}

TEST(Hosts, ASidePlacesTheProcessThatServesIt) {
  // The flat case has one free field for all sides; a model of its own makes the right one a process.
  const auto scene = parsed(with("right = { model = \"wave\" }", "right = { model = \"fe\" }",
                                 hosts("right = { start = \"ssh\", host = \"me@node2\" }")));
  const auto plan = scene::plan(scene);
  EXPECT_EQ(host_of(scene, source_of(plan, Side::left)), nullptr);
  const Host* host = host_of(scene, source_of(plan, Side::right));
  ASSERT_NE(host, nullptr);
  EXPECT_EQ(*host, (Host{StartBy::ssh, "me@node2", "", "tremolo", ""}));
}

TEST(Hosts, OneSideOfAProcessIsEnough) {
  const auto scene = parsed(hosts("base = { start = \"join\" }"));
  const auto plan = scene::plan(scene);
  ASSERT_EQ(plan.sources.size(), 1U);
  ASSERT_NE(host_of(scene, plan.sources.front()), nullptr);
  EXPECT_EQ(host_of(scene, plan.sources.front())->start, StartBy::join);
}

TEST(Hosts, TwoHostsForOneProcessAreRefused) {
  EXPECT_THAT(errors_of(hosts("left = { start = \"join\" }\nbase = { start = \"slurm\" }")),
              ElementsAre("case.toml:34:8: [hosts.base] the base has the same free field as the left, from "
                          "one process 'left-right-base': give it the same host, or none"));
}

TEST(Rules, HostsCanMeet) {
  const std::string left = "left = { start = \"join\" }";
  for (const auto* good : {"tcp://10.0.0.1:5555", "tcp://ib0:*", "tcp://*:1", "tcp://[fd00::1]:65535"})
    EXPECT_THAT(errors_of(hosts(left, good)), IsEmpty()) << good;
  for (const auto* bad : {"10.0.0.1:5555", "ipc:///tmp/hub", "tcp://10.0.0.1", "tcp://:5555", "tcp://node2:0",
                          "tcp://a:65536", "tcp://a:5555x", "tcp://fd00::1:5555", "tcp://a b:5555"})
    EXPECT_THAT(errors_of(hosts(left, bad)),
                ElementsAre(HasSubstr(std::string("case.toml:32:12: [hosts] 'endpoint' = \"") + bad +
                                      "\" must be tcp://ADDRESS:PORT")))
        << bad;
}

TEST(Hosts, WhatCannotBeMeantIsRefused) {
  EXPECT_THAT(errors_of(hosts("")), ElementsAre(HasSubstr("[hosts] no process is placed")));
  EXPECT_THAT(errors_of(plus("[hosts]\nleft = { start = \"join\" }\n")),
              ElementsAre(HasSubstr("missing 'endpoint'")));
  EXPECT_THAT(errors_of(hosts("left = { host = \"a\" }")), ElementsAre(HasSubstr("missing 'start'")));
  EXPECT_THAT(errors_of(hosts("left = { start = \"ssh\" }")), ElementsAre(HasSubstr("missing 'host'")));
  EXPECT_THAT(errors_of(hosts("left = { start = \"slurm\", host = \"a\" }")),
              ElementsAre(HasSubstr("'host' does not apply to start = \"slurm\", only to ssh")));
  EXPECT_THAT(errors_of(hosts("left = { start = \"join\" }\ntop = { start = \"join\" }")),
              ElementsAre(HasSubstr("unknown key 'top'")));
  for (const auto* bad : {"-oProxyCommand=x", "node2 rm", "'node2'"})
    EXPECT_THAT(errors_of(hosts(std::string("left = { start = \"ssh\", host = \"") + bad + "\" }")),
                ElementsAre(HasSubstr("is not one that ssh can go to")));
}

std::string ranks_on(const std::string& keys) {
  return plus("[hosts.domain]\n" + keys + "\n");
}

TEST(Hosts, RanksHaveMachinesAndNoEndpoint) {
  const auto scene = parsed(ranks_on("start = \"ssh\"\nmachines = [\"node2\", \"n-3.a:8\"]"));
  ASSERT_TRUE(scene.hosts.domain);
  ASSERT_EQ(scene.hosts.domain->machines.size(), 2U);
  EXPECT_EQ(scene.hosts.domain->machines[0].name, "node2");
  EXPECT_FALSE(scene.hosts.domain->machines[0].most);
  EXPECT_EQ(scene.hosts.domain->machines[1].name, "n-3.a");
  EXPECT_EQ(scene.hosts.domain->machines[1].most, 8);
  EXPECT_THAT(explain(scene, plan(scene)),
              HasSubstr("its ranks with --ranks N: here, node2, n-3.a (at most 8), through ssh"));
  const auto job = parsed(ranks_on("start = \"slurm\""));
  EXPECT_EQ(job.hosts.domain->start, StartRanksBy::slurm);
  EXPECT_THAT(explain(job, plan(job)), HasSubstr("its ranks with --ranks N: on the nodes of the Slurm job"));
}

TEST(Rules, RanksCanBePlaced) {
  const auto machines = [](const std::string& list) {
    return ranks_on("start = \"ssh\"\nmachines = " + list);
  };
  EXPECT_THAT(errors_of(ranks_on("start = \"ssh\"")),
              ElementsAre(HasSubstr("[hosts.domain] missing 'machines', array of strings")));
  EXPECT_THAT(errors_of(ranks_on("start = \"slurm\"\nmachines = [\"a\"]")),
              ElementsAre(HasSubstr("'machines' does not apply to start = \"slurm\", only to ssh")));
  EXPECT_THAT(errors_of(ranks_on("start = \"join\"")),
              ElementsAre(HasSubstr("case.toml:32:9: [hosts.domain] 'start' = \"join\" is not known")));
  EXPECT_THAT(errors_of(machines("\"node2\"")),
              ElementsAre(HasSubstr("'machines' must be an array of strings")));
  EXPECT_THAT(errors_of(machines("[]")), ElementsAre(HasSubstr("'machines' is empty")));
  EXPECT_THAT(errors_of(machines("[1]")),
              ElementsAre(HasSubstr("'machines' must be a string, found an integer")));
  EXPECT_THAT(errors_of(machines("[\"a\", \"a\"]")),
              ElementsAre(HasSubstr("'a' stands twice in 'machines'")));
  EXPECT_THAT(
      errors_of(machines("[\"a\", \"a:2\"]")),
      ElementsAre(
          "case.toml:33:12: [hosts.domain] 'a' stands twice in 'machines': give it one number of ranks"));
  for (const auto* bad : {"me@node2", "a_b", "-x", "node2,node3", "node2:", "node2:8x", "[fd00::1]"})
    EXPECT_THAT(errors_of(machines("[\"" + std::string(bad) + "\"]")),
                ElementsAre(HasSubstr("must be NAME or NAME:RANKS")))
        << bad;
  for (const auto* bad : {"node2:0", "node2:-1", "node2:5000"})
    EXPECT_THAT(errors_of(machines("[\"" + std::string(bad) + "\"]")),
                ElementsAre(HasSubstr("ranks must be in [1, 4096]")))
        << bad;
}

TEST(Hosts, DataFilesAreThoseThatTheCaseNames) {
  EXPECT_THAT(data_files(parsed(std::string(flat_case))), IsEmpty());
  const auto file = std::filesystem::path(::testing::TempDir()) / "hosts_record.AT2";
  std::ofstream(file) << "NPTS= 3, DT= .01 SEC\n0.0 0.1 0.0\n";
  const auto scene =
      parsed(with("pulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity = 0.1 }",
                  "file = \"" + file.string() + "\"\nkind = \"outcrop\""));
  EXPECT_THAT(data_files(scene), ElementsAre(std::filesystem::absolute(file).lexically_normal()));
  std::filesystem::remove(file);
}

} // namespace
} // namespace tremolo::scene::testing
