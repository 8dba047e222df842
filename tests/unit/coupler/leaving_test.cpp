// A participant that leaves loses nothing of what it has sent, however slowly the hub takes it.

#include "coupler/wire/connection.hpp"
#include "coupler/wire/handshake/messages.hpp"
#include "coupler/wire/sockets.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <zmq.hpp>

namespace tremolo::coupler {
namespace {

TEST(Leaving, WhatASlowHubHasNotTakenYetIsNotLost) {
  constexpr std::size_t values = 1U << 17U; // a frame is a megabyte
  constexpr int frames = 64;                // more than sockets and pipes hold
  const auto case_file = std::filesystem::path(testing::TempDir()) / "leaving.toml";
  std::ofstream(case_file) << "case";
  zmq::context_t context;
  zmq::socket_t hub(context, zmq::socket_type::router);
  hub.set(zmq::sockopt::rcvhwm, 1);
  hub.set(zmq::sockopt::rcvtimeo, 5000);
  hub.set(zmq::sockopt::linger, 0);
  hub.bind("tcp://127.0.0.1:*");
  ParticipantOptions options{.case_file = case_file,
                             .name = "domain",
                             .endpoint = hub.get(zmq::sockopt::last_endpoint),
                             .session = 1};
  const std::jthread participant([&] {
    Connection connection(options);
    connection.introduce({"HELLO"});
    for (int i = 0; i < frames; ++i)
      connection.send({.session = 1, .sender = 1, .steps = 1, .count = values}, FrameDraft(values));
    connection.take_leave({"BYE"});
  });
  std::string peer;
  const auto next = [&] {
    zmq::message_t from;
    zmq::message_t raw;
    if (!hub.recv(from) || !hub.recv(raw))
      return std::string();
    peer = from.to_string();
    return raw.to_string();
  };
  const auto answer = [&](const Message& message) {
    hub.send(zmq::buffer(peer), zmq::send_flags::sndmore);
    hub.send(zmq::buffer(to_text(message)), zmq::send_flags::none);
  };
  EXPECT_NE(next().find("HELLO"), std::string::npos);
  answer({"WELCOME", {{"number", 1}}});
  // Longer than the participant's linger.
  std::this_thread::sleep_for(std::chrono::milliseconds(800));
  for (int i = 0; i < frames; ++i)
    ASSERT_GT(next().size(), values * sizeof(double)) << "frame " << i << " is lost";
  EXPECT_NE(next().find("BYE"), std::string::npos);
  answer({"BYE"});
}

} // namespace
} // namespace tremolo::coupler
