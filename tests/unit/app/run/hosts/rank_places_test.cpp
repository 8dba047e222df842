// Ranks of the domain on several machines: how many on each, what mpirun is told, and what is refused.

#include "app/run/hosts/domain_ranks.hpp"
#include "app/run/hosts/rank_places.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>

namespace tremolo::app {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

const std::vector<scene::RankMachine> two_others{{"node2", std::nullopt}, {"node3", 2}};

TEST(RankPlaces, AreAsEvenAsTheMachinesAllow) {
  EXPECT_THAT(rank_places(3, {}, 4, false), ElementsAre(3));
  EXPECT_THAT(rank_places(2, two_others, 4, false), ElementsAre(1, 1, 0));
  EXPECT_THAT(rank_places(6, two_others, 4, false), ElementsAre(2, 2, 2));
  EXPECT_THAT(rank_places(9, two_others, 4, false), ElementsAre(4, 3, 2));
}

TEST(RankPlaces, MoreThanTheMachinesTakeMustBeAskedFor) {
  EXPECT_THAT(rank_places(10, two_others, 4, false), ElementsAre(4, 4, 2));
  EXPECT_THROW(rank_places(11, two_others, 4, false), std::invalid_argument);
  EXPECT_THAT(rank_places(14, two_others, 4, true), ElementsAre(6, 5, 3));
}

/// ssh and mpirun are files on a PATH of this test's own; nobody starts them here.
class RanksElsewhere : public ::testing::Test {
protected:
  void SetUp() override {
    for (const char* program : {"ssh", "mpirun"})
      fs::permissions(folder_.write(program, "#!/bin/sh\n"), fs::perms::owner_all);
    ::setenv("PATH", (folder_ / "").c_str(), 1);
    for (const char* name : {"SLURM_JOB_ID", "SLURM_NODEID", "SLURM_NTASKS"})
      ::unsetenv(name);
  }
  void TearDown() override {
    ::setenv("PATH", path_.c_str(), 1);
    for (const char* name : {"SLURM_JOB_ID", "SLURM_NODEID", "SLURM_NTASKS"})
      ::unsetenv(name);
  }

  coupler::ProcessSpec started(int count, bool local = false) {
    coupler::ProcessSpec domain{
        .name = "domain", .role = coupler::Role::domain, .program = "/opt/tremolo-domain"};
    start_as_ranks(domain, scene_, {.count = count, .oversubscribe = true}, local, "/dev/shm/tremolo-x",
                   30.0);
    return domain;
  }

  /// The reason, before which nothing else stops ranks here.
  std::string refusal(int count) {
    try {
      check_ranks(scene_, {.count = count, .oversubscribe = false}, false);
    } catch (const std::exception& reason) {
      return reason.what();
    }
    return {};
  }

  tremolo::testing::TemporaryFolder folder_;
  std::string path_ = std::getenv("PATH");
  scene::Case scene_;
};

TEST_F(RanksElsewhere, OneProcessNeedsNoMpirun) {
  EXPECT_EQ(started(1).program, "/opt/tremolo-domain");
}

TEST_F(RanksElsewhere, WithoutTheTableAllRunHere) {
  const auto domain = started(3);
  EXPECT_EQ(domain.program, folder_ / "mpirun");
  EXPECT_THAT(domain.arguments, IsSupersetOf({"-n", "3", "isolated", "/opt/tremolo-domain", "--ranks"}));
  EXPECT_THAT(domain.arguments, Not(Contains("--host")));
  EXPECT_THAT(domain.environment,
              IsSupersetOf({"TMPDIR=/dev/shm/tremolo-x", "TREMOLO_SHARED_MEMORY=/dev/shm/tremolo-x"}));
}

TEST_F(RanksElsewhere, SshGoesToTheMachinesAfterThisOne) {
  scene_.hosts.domain = {
      scene::StartRanksBy::ssh, {{"node2", 8}, {"node3", std::nullopt}}, "--mca btl_tcp_if_include ib0"};
  const auto domain = started(3);
  EXPECT_THAT(domain.arguments, Contains("localhost:1,node2:1,node3:1"));
  EXPECT_THAT(domain.arguments,
              Contains((folder_ / "ssh").string() + " -n -x -o BatchMode=yes -o ConnectTimeout=30 --"));
  EXPECT_THAT(domain.arguments, IsSupersetOf({"btl_tcp_if_include", "ib0"}));
  EXPECT_THAT(started(3, true).arguments, Not(Contains(HasSubstr("node2")))) << "--local";
}

TEST_F(RanksElsewhere, SlurmIsLeftToMpirun) {
  scene_.hosts.domain = {scene::StartRanksBy::slurm, {}, ""};
  const auto domain = started(3);
  EXPECT_THAT(domain.arguments, Not(Contains("ras")));
  EXPECT_THAT(domain.environment, Not(Contains(HasSubstr("TMPDIR"))));
}

#ifdef TREMOLO_MPI
TEST_F(RanksElsewhere, WhatCannotStartIsSaidBeforeAnythingIsStarted) {
  scene_.hosts.domain = {scene::StartRanksBy::ssh, {{"localhost", 8}}, ""};
  EXPECT_THAT(refusal(2), HasSubstr("[hosts.domain] names this machine, 'localhost'"));
  scene_.hosts.domain = {scene::StartRanksBy::slurm, {}, ""};
  EXPECT_THAT(refusal(2), HasSubstr("this is not a Slurm job"));
  ::setenv("SLURM_JOB_ID", "7", 1);
  EXPECT_THAT(refusal(2), HasSubstr("rank 0 comes to the first node of the job"));
  ::setenv("SLURM_NODEID", "0", 1);
  ::setenv("SLURM_NTASKS", "4", 1);
  EXPECT_THAT(refusal(5), HasSubstr("--ranks 5: the job has 4 tasks"));
}
#endif

} // namespace
} // namespace tremolo::app
