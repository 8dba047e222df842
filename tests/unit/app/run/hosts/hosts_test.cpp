#include "app/run/hosts/hosts.hpp"
#include "tests/support/temporary_folder.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tremolo::app {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// ssh and srun are files on a PATH of this test's own; nobody starts them here.
class Hosts : public ::testing::Test {
protected:
  void SetUp() override {
    for (const char* program : {"ssh", "srun"})
      fs::permissions(folder_.write(program, "#!/bin/sh\n"), fs::perms::owner_all);
    ::setenv("PATH", (folder_ / "").c_str(), 1);
    ::setenv("SLURM_JOB_ID", "7", 1);
    ::setenv("SLURM_JOB_NUM_NODES", "3", 1);
  }
  void TearDown() override { ::setenv("PATH", path_.c_str(), 1); }

  std::vector<std::string> words(const scene::Host& host, int number = 1) {
    return elsewhere(host, "left", "/my keys", 30.0, number).command("tcp://10.0.0.1:5555", "00ff");
  }

  tremolo::testing::TemporaryFolder folder_;
  std::string path_ = std::getenv("PATH");
};

TEST_F(Hosts, SshAsksNobodyAndGoesToTheHost) {
  const auto found =
      words({scene::StartBy::ssh, "user@node2", "-p 2222 -o Compression=no", "tremolo", "/keys there"});
  EXPECT_THAT(found,
              ElementsAre(folder_ / "ssh", "-n", "-T", "-o", "BatchMode=yes", "-o", "ConnectTimeout=30", "-p",
                          "2222", "-o", "Compression=no", "--", "user@node2", ::testing::_));
}

TEST_F(Hosts, AShellThereReadsEachWordAsItIs) {
  // printf, in place of tremolo, writes its words as a shell gives them to it.
  const auto line =
      words({scene::StartBy::ssh, "node2", "", "printf '%s\\n'", "/it's \"here\" $HOME"}).back();
  ::setenv("PATH", path_.c_str(), 1);
  FILE* shell = ::popen(line.c_str(), "r");
  std::array<char, 1000> text{};
  const auto size = std::fread(text.data(), 1, text.size(), shell);
  EXPECT_EQ(::pclose(shell), 0);
  EXPECT_EQ(std::string(text.data(), size),
            "join\ntcp://10.0.0.1:5555\n--role\nleft\n--keys\n/it's \"here\" $HOME\n--run\n00ff\n");
}

TEST_F(Hosts, KeysAreWhereTheyAreHereIfNotSaidOtherwise) {
  EXPECT_THAT(words({scene::StartBy::ssh, "node2", "", "tremolo", ""}).back(),
              HasSubstr("--keys '/my keys'"));
}

TEST_F(Hosts, SlurmPlacesEachProcessOnItsNode) {
  const scene::Host host{scene::StartBy::slurm, "", "--mem=4G", "tremolo", ""};
  EXPECT_THAT(words(host, 1), Contains("--relative=1"));
  EXPECT_THAT(words(host, 2), Contains("--relative=2"));
  EXPECT_THAT(words(host, 3), Contains("--relative=0")) << "a job with fewer nodes than processes";
  EXPECT_THAT(words(host), Contains("--mem=4G"));
}

TEST_F(Hosts, WhatCannotStartIsSaidBeforeAnythingIsStarted) {
  ::unsetenv("SLURM_JOB_ID");
  EXPECT_THROW(words({scene::StartBy::slurm, "", "", "tremolo", ""}), std::runtime_error);
  fs::remove(folder_ / "ssh");
  EXPECT_THROW(words({scene::StartBy::ssh, "node2", "", "tremolo", ""}), std::runtime_error);
}

TEST_F(Hosts, TheUserIsToldTheCommand) {
  const auto by_hand = elsewhere({scene::StartBy::join, "", "", "", ""}, "left", "keys", 30.0, 1);
  EXPECT_EQ(by_hand.started_by, "");
  EXPECT_THAT(by_hand.command("tcp://10.0.0.1:5555", "00ff"),
              ElementsAre("tremolo", "join", "tcp://10.0.0.1:5555", "--role", "left", "--keys", "keys"));
}

} // namespace
} // namespace tremolo::app
