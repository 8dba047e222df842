// Who gets an invitation from the hub, and what everybody else is told.

#include "coupler/hub/hub.hpp"
#include "coupler/launch/joining.hpp"
#include "coupler/launch/run_endpoint.hpp"
#include "coupler/participant.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/sockets.hpp"
#include "tests/support/temporary_folder.hpp"

#include <atomic>
#include <filesystem>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

namespace tremolo::coupler {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr std::uint64_t session = 0x0123456789abcdef;
constexpr const char* run_number = "00000000000000ab";

/// A hub that expects 'left' and 'right' from elsewhere and 'base' and 'domain' on this machine, at work in a
/// thread of its own.
class Joined : public ::testing::Test {
protected:
  void SetUp() override {
    for (const char* name : {"hub", "left", "right", "base"})
      write_key_pair(keys_, name);
    HubOptions options;
    options.session = session;
    options.case_text = "depth = 10.0\n";
    options.participants = {{"left", Role::source, true},
                            {"right", Role::source, true},
                            {"base", Role::source},
                            {"domain", Role::domain}};
    options.keys = keys_;
    options.note = [](const std::string&) {};
    options.outer_endpoint = "tcp://127.0.0.1:*";
    options.run_number = run_number;
    options.files = {{"/data/motion.csv", 3, "00000001"}};
    hub_.emplace(context_, endpoint_.address(), options);
    address_ = hub_->outer_endpoint();
    thread_ = std::thread([this] {
      while (!over_) {
        zmq::pollitem_t item{hub_->socket().handle(), 0, ZMQ_POLLIN, 0};
        zmq::poll(&item, 1, std::chrono::milliseconds(10));
        hub_->take_messages();
        hub_->tick();
        failed_ = hub_->failure().has_value();
      }
    });
  }
  void TearDown() override { end(); }
  void end() {
    over_ = true;
    if (thread_.joinable())
      thread_.join();
  }

  JoinOptions as(const std::string& name) {
    return {.endpoint = address_, .name = name, .keys = keys_, .run = {}, .deadline = 10.0};
  }

  /// Keys in which `name` has the pair of `owner`.
  fs::path stolen(const std::string& name, const std::string& owner) {
    const auto folder = keys_ / "stolen";
    fs::create_directories(folder);
    fs::copy_file(keys_ / "hub.public", folder / "hub.public");
    for (const char* kind : {".public", ".secret"})
      fs::copy_file(keys_ / (owner + kind), folder / (name + kind));
    return folder;
  }

  static std::string failure_of(const std::function<void()>& deed) {
    try {
      deed();
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing failed";
  }

  std::string refusal(const JoinOptions& options) {
    return failure_of([&] { Joining(options).invitation(); });
  }

  tremolo::testing::TemporaryFolder folder_;
  fs::path keys_ = folder_ / "";
  RunEndpoint endpoint_{Transport::ipc};
  zmq::context_t context_{new_context(4)};
  std::optional<Hub> hub_;
  std::string address_;
  std::atomic<bool> over_ = false;
  std::atomic<bool> failed_ = false;
  std::thread thread_;
};

TEST_F(Joined, LearnsSessionCaseAndFiles) {
  Joining line(as("left"));
  const auto invitation = line.invitation();
  EXPECT_EQ(invitation.session, session);
  EXPECT_EQ(invitation.case_text, "depth = 10.0\n");
  EXPECT_EQ(invitation.files, (std::vector<DataFile>{{"/data/motion.csv", 3, "00000001"}}));
  EXPECT_FALSE(line.hub_is_gone());
}

TEST_F(Joined, MayNameTheRunAndTheCaseThatItMeans) {
  auto options = as("left");
  options.run = run_number;
  options.case_text = "depth = 10.0\n";
  EXPECT_EQ(Joining(options).invitation().session, session);
}

TEST_F(Joined, OtherCaseIsRefusedWithTheLineThatDiffers) {
  auto options = as("left");
  options.case_text = "depth = 12.0\n";
  EXPECT_THAT(refusal(options), AllOf(HasSubstr("another case"), HasSubstr("12.0"), HasSubstr("10.0")));
}

TEST_F(Joined, OtherRunIsRefused) {
  auto options = as("left");
  options.run = "ffffffffffffffff";
  EXPECT_THAT(refusal(options),
              HasSubstr("'left' is meant for run ffffffffffffffff, this is run 00000000000000ab"));
}

TEST_F(Joined, KeyOfAnotherParticipantIsRefused) {
  auto options = as("right");
  options.keys = stolen("right", "left");
  EXPECT_THAT(refusal(options), HasSubstr("'right' came with the key of 'left'"));
}

TEST_F(Joined, HelloWithTheKeyOfAnotherIsRefusedToo) {
  const auto keys = stolen("right", "left");
  const auto refused = failure_of([&] {
    const FieldDescription field{.name = "total", .y = {-1.0, 0.0}, .time_step = 0.01, .step_count = 10};
    SourceClient({.case_file = folder_.write("case", "depth = 10.0\n"),
                  .name = "right",
                  .endpoint = address_,
                  .session = session,
                  .out = {},
                  .deadlines = {},
                  .keys = keys},
                 {field});
  });
  EXPECT_THAT(refused, HasSubstr("'right' came with the key of 'left'"));
}

TEST_F(Joined, ProcessThatTheRunStartsItselfHasNoBusinessOutside) {
  auto options = as("base");
  options.deadline = 1.0;
  EXPECT_THAT(refusal(options), HasSubstr("the hub does not know this key"));
}

TEST_F(Joined, SecondOfTheSameNameIsRefusedAsLongAsTheFirstIsThere) {
  {
    Joining first(as("left"));
    first.invitation();
    EXPECT_THAT(refusal(as("left")), HasSubstr("already taking part"));
  }
  // When the hub has seen the end of the first.
  std::string last;
  for (int i = 0; i < 100 && last != "nothing failed"; ++i)
    last = refusal(as("left"));
  EXPECT_EQ(last, "nothing failed");
}

TEST_F(Joined, GivingUpEndsTheRunWithTheReason) {
  Joining line(as("left"));
  line.invitation();
  line.abandon("'left' was killed on its machine");
  for (int i = 0; i < 500 && !failed_; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  end();
  ASSERT_TRUE(hub_->failure().has_value());
  EXPECT_EQ(hub_->failure()->participant, "left");
  EXPECT_EQ(hub_->failure()->text, "'left' was killed on its machine");
}

TEST_F(Joined, SeesTheEndOfTheHub) {
  Joining line(as("left"));
  line.invitation();
  end();
  hub_.reset();
  bool gone = false;
  for (int i = 0; i < 500 && !gone; ++i) {
    gone = line.hub_is_gone();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_TRUE(gone);
}

TEST_F(Joined, WaitsNoLongerThanItsDeadline) {
  auto options = as("left");
  options.deadline = 0.5;
  end();
  hub_.reset();
  EXPECT_THAT(refusal(options), AllOf(HasSubstr("'left' waited 0."), HasSubstr("deadline 0.5 s")));
}

TEST(HubForOthers, NeedsKeysAndOneForEachParticipant) {
  zmq::context_t context;
  const tremolo::testing::TemporaryFolder folder;
  HubOptions options;
  options.participants = {
      {"left", Role::source, true}, {"right", Role::source, true}, {"domain", Role::domain}};
  options.note = [](const std::string&) {};
  options.outer_endpoint = "tcp://127.0.0.1:*";
  const RunEndpoint endpoint(Transport::ipc);
  EXPECT_THROW(Hub(context, endpoint.address(), options), Error);
  options.keys = folder / "";
  for (const char* name : {"hub", "left"})
    write_key_pair(options.keys, name);
  fs::copy_file(options.keys / "left.public", options.keys / "right.public");
  EXPECT_THROW(Hub(context, endpoint.address(), options), Error);
}

} // namespace
} // namespace tremolo::coupler
