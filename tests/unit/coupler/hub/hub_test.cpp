// What the hub answers to participants that are driven by hand, message by message.

#include "coupler/hub/hub.hpp"
#include "coupler/launch/run_endpoint.hpp"
#include "coupler/wire/frame.hpp"
#include "coupler/wire/handshake/messages.hpp"
#include "coupler/wire/sockets.hpp"

#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <zmq.hpp>

namespace tremolo::coupler {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr std::uint64_t session = 0x0123456789abcdef;

class HubByHand : public testing::Test {
protected:
  HubByHand() { open(); }

  /// Another hub in its place.
  /// @param elsewhere whether 'left' comes from another machine
  void open(bool elsewhere = false) {
    hub_.reset();
    hub_.emplace(context_, endpoint_.address(),
                 HubOptions{.session = session,
                            .case_text = "case",
                            .participants = {{"left", Role::source, elsewhere}, {"domain", Role::domain}},
                            .deadlines = {},
                            .note = [this](const std::string& note) { notes_ += note + "\n"; }});
  }

  zmq::socket_t connected() { return connected_dealer(context_, hub_->endpoint()); }

  static json field(std::size_t points = 2) {
    json y = json::array();
    for (std::size_t i = 0; i < points; ++i)
      y.push_back(static_cast<double>(i));
    return {{"name", "total"},    {"y", y},
            {"x_reference", 0.0}, {"slowness_x", 0.0},
            {"start_time", -1.0}, {"time_step", 0.01},
            {"step_count", 2000}};
  }

  static json hello(const std::string& name, const json& changes = json::object()) {
    json message{{"type", "HELLO"},
                 {"protocol", protocol_version},
                 {"session", session_text(session)},
                 {"name", name},
                 {"role", name == "domain" ? "domain" : "source"},
                 {"build", "by hand"},
                 {"units", "SI"},
                 {"case", text_crc("case")}};
    if (name != "domain")
      message["fields"] = {field()};
    message.update(changes);
    return message;
  }

  static json bye() { return {{"type", "BYE"}, {"passes", json::array()}, {"waiting", 0.0}}; }

  static void send(zmq::socket_t& socket, const json& message) {
    const std::string text = message.dump();
    socket.send(zmq::buffer(text), zmq::send_flags::none);
  }

  /// What the hub answers first.
  json answer(zmq::socket_t& socket) {
    for (int i = 0; i < 400; ++i) {
      hub_->take_messages();
      zmq::message_t raw;
      if (wait_readable(socket, 0.01) && socket.recv(raw, zmq::recv_flags::dontwait))
        return json::parse(raw.to_string());
    }
    ADD_FAILURE() << "no answer";
    return {};
  }

  /// What is said to a source that comes with these changes in its HELLO.
  std::string refusal(const json& changes) {
    auto socket = connected();
    send(socket, hello("left", changes));
    const json said = answer(socket);
    EXPECT_EQ(said.value("type", ""), "REFUSE") << said;
    return said.value("reason", "");
  }

  void tick_for(double seconds) {
    for (const auto start = Clock::now(); seconds_since(start) < seconds;) {
      hub_->take_messages();
      hub_->tick();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  /// Brings the run of 'left' from another machine and of the domain to its first step.
  std::pair<zmq::socket_t, zmq::socket_t> left_and_domain() {
    open(true);
    auto left = connected();
    auto domain = connected();
    send(left, hello("left"));
    send(domain, hello("domain"));
    EXPECT_EQ(answer(left).value("type", ""), "WELCOME");
    EXPECT_EQ(answer(domain).value("type", ""), "WELCOME");
    return {std::move(left), std::move(domain)};
  }

  RunEndpoint endpoint_{Transport::ipc};
  zmq::context_t context_;
  std::string notes_;
  std::optional<Hub> hub_;
};

TEST_F(HubByHand, SaysInWelcomeHowManyStepsAFrameHolds) {
  // 1 MiB = 2^20 bytes; a step has 80 bytes a point.
  for (const auto& [points, steps] :
       {std::pair<std::size_t, std::size_t>{100, 64}, {625, 20}, {700, 18}, {5000, 2}, {20000, 1}}) {
    open();
    auto left = connected();
    auto domain = connected();
    send(left, hello("left", {{"fields", {field(points)}}}));
    send(domain, hello("domain"));
    const json welcome = answer(left);
    ASSERT_EQ(welcome.value("type", ""), "WELCOME");
    EXPECT_EQ(welcome["sources"][0]["fields"][0]["steps_per_frame"], steps);
    EXPECT_EQ(answer(domain)["sources"][0]["fields"][0]["steps_per_frame"], steps);
  }
}

TEST_F(HubByHand, RefusesACountOfStepsThatIsNone) {
  auto negative = field();
  negative["step_count"] = -1;
  EXPECT_THAT(
      refusal({{"fields", {negative}}}),
      AllOf(HasSubstr("'left' (build by hand)"), HasSubstr("'step_count' is -1, expected a whole number")));
  ASSERT_TRUE(hub_->failure());
  EXPECT_EQ(hub_->failure()->participant, "left");
}

TEST_F(HubByHand, RefusesHalfAStep) {
  auto half = field();
  half["step_count"] = 2000.5;
  EXPECT_THAT(refusal({{"fields", {half}}}), HasSubstr("'step_count' is 2000.5, expected a whole number"));
}

TEST_F(HubByHand, RefusesTwoFieldsOfOneName) {
  EXPECT_THAT(refusal({{"fields", {field(), field()}}}), HasSubstr("it serves two fields called 'total'"));
}

TEST_F(HubByHand, TellsWhatIsMissingInWordsOfItsOwn) {
  EXPECT_THAT(refusal({{"fields", "all"}}),
              AllOf(HasSubstr("'fields' is \"all\", expected a list"), Not(HasSubstr("json.exception"))));
}

TEST_F(HubByHand, DoesNotTellTheSessionToThoseWhoDoNotKnowIt) {
  EXPECT_THAT(refusal({{"session", "ffffffffffffffff"}}),
              AllOf(HasSubstr("session ffffffffffffffff"), Not(HasSubstr(session_text(session)))));
  EXPECT_FALSE(hub_->failure());
}

TEST_F(HubByHand, NamesAMessageOfSeveralParts) {
  auto socket = connected();
  socket.send(zmq::message_t(), zmq::send_flags::sndmore);
  send(socket, hello("left"));
  EXPECT_THAT(answer(socket).value("reason", ""), HasSubstr("a message of 2 parts, expected one"));
  EXPECT_THAT(notes_, HasSubstr("refused: a message of 2 parts"));
}

TEST_F(HubByHand, ReasonsOfOthersAreMadePrintable) {
  auto left = connected();
  send(left, hello("left"));
  send(left, {{"type", "ABORT"}, {"reason", "\x1b[31mno\x1b[0m"}});
  for (int i = 0; i < 400 && !hub_->failure(); ++i) {
    hub_->take_messages();
    wait_readable(left, 0.01);
  }
  ASSERT_TRUE(hub_->failure());
  EXPECT_EQ(hub_->failure()->text, "\\x1b[31mno\\x1b[0m");
}

TEST_F(HubByHand, SourceWhoseConnectionIsGoneInTheMidstHasFailed) {
  auto [left, domain] = left_and_domain();
  left.close();
  tick_for(1.6);
  ASSERT_TRUE(hub_->failure());
  EXPECT_EQ(hub_->failure()->participant, "left");
  EXPECT_THAT(hub_->failure()->text, HasSubstr("the connection to 'left' on another machine is gone"));
}

TEST_F(HubByHand, SourceWhoseConnectionIsGoneAfterItsDismissalHasNotFailed) {
  auto [left, domain] = left_and_domain();
  send(domain, bye());
  ASSERT_EQ(answer(left).value("type", ""), "BYE");
  left.close(); // its own BYE is lost on the way
  tick_for(1.6);
  EXPECT_FALSE(hub_->failure()) << hub_->failure()->text;
  EXPECT_FALSE(hub_->has_left("left"));
  EXPECT_TRUE(hub_->has_dismissed_sources());
}

// What came to its machine after its process has ended would make the kernel there drop a BYE on its way.
TEST_F(HubByHand, SaysNothingToASourceThatIsDismissed) {
  auto [left, domain] = left_and_domain();
  tick_for(0.3);
  ASSERT_EQ(answer(left).value("type", ""), "BEAT");
  send(domain, bye());
  json said;
  do
    said = answer(left);
  while (said.value("type", "") == "BEAT");
  ASSERT_EQ(said.value("type", ""), "BYE");
  tick_for(0.8);
  zmq::message_t more;
  EXPECT_FALSE(left.recv(more, zmq::recv_flags::dontwait)) << more.to_string();
}

} // namespace
} // namespace tremolo::coupler
