#include "coupler/conformance/source_probe.hpp"

#include "coupler/wire/error.hpp"
#include "coupler/wire/sockets.hpp"

#include <chrono>
#include <fmt/format.h>
#include <random>
#include <thread>
#include <utility>

namespace tremolo::coupler {

namespace {

constexpr double beat_interval_s = 0.25;
constexpr std::size_t shown_lines = 3;

ParticipantOptions participant(const ProbeOptions& probe, const zmq::socket_t& socket) {
  std::random_device device;
  return {.case_file = probe.case_file,
          .name = probe.name,
          .endpoint = socket.get(zmq::sockopt::last_endpoint),
          .session = (static_cast<std::uint64_t>(device()) << 32) | device(),
          .out = probe.folder,
          .deadlines = probe.deadlines};
}

Command command(const ProbeOptions& probe, const ParticipantOptions& options) {
  std::vector<std::string> words = probe.command;
  const auto common = command_line(options);
  words.insert(words.end(), common.begin(), common.end());
  return {std::move(words), environment(options)};
}

} // namespace

SourceProbe::SourceProbe(const ProbeOptions& options)
    : endpoint_(Transport::ipc), context_(new_context(1)),
      socket_(bound_router(context_, endpoint_.address())), options_(participant(options, socket_)),
      process_(options.name, command(options, options_), options.folder / (options.name + ".log")),
      last_beat_(Clock::now()) {}

Message SourceProbe::hello() {
  const auto start = Clock::now();
  while (seconds_since(start) < options_.deadlines.connect) {
    if (const auto incoming = receive(0.05); incoming && incoming->message)
      return *incoming->message;
  }
  throw Error(fmt::format("no HELLO within {} s", options_.deadlines.connect));
}

void SourceProbe::send(const Message& message) {
  const std::string text = to_text(message);
  try {
    socket_.send(zmq::buffer(routing_id_), zmq::send_flags::sndmore | zmq::send_flags::dontwait);
    socket_.send(zmq::buffer(text), zmq::send_flags::dontwait);
  } catch (const zmq::error_t& error) {
    // It is gone; its end will be seen.
    if (error.num() != EHOSTUNREACH)
      throw;
  }
}

std::optional<Incoming> SourceProbe::receive(double wait_s) {
  beat();
  if (wait_readable(socket_, wait_s))
    if (auto incoming = take())
      return incoming;
  // Its last words may still be on their way when the process has ended.
  if (process_.ended() && !wait_readable(socket_, 0.1))
    throw Error(last_words());
  return std::nullopt;
}

std::optional<Incoming> SourceProbe::take() {
  zmq::message_t routing_id;
  Incoming incoming;
  if (!socket_.recv(routing_id, zmq::recv_flags::dontwait))
    return std::nullopt;
  std::size_t parts = 0;
  for (bool more = routing_id.more(); more; more = incoming.raw.more(), ++parts)
    if (!socket_.recv(incoming.raw, zmq::recv_flags::dontwait))
      return std::nullopt;
  require_one_part(parts);
  routing_id_ = routing_id.to_string();
  if (looks_like_message(incoming.frame()))
    incoming.message = parse_message(incoming.frame());
  return incoming;
}

void SourceProbe::beat() {
  if (routing_id_.empty() || seconds_since(last_beat_) < beat_interval_s)
    return;
  last_beat_ = Clock::now();
  send({"BEAT"});
}

void SourceProbe::vanish() {
  socket_.close();
}

bool SourceProbe::ends_within(double wait_s) {
  const auto start = Clock::now();
  while (!process_.ended()) {
    if (seconds_since(start) > wait_s)
      return false;
    if (socket_ && wait_readable(socket_, 0.01))
      take();
    else
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

std::string SourceProbe::last_words() const {
  std::string text = "the program " + process_.ending();
  for (const auto& line : process_.last_lines(shown_lines))
    text += "; " + line;
  return text;
}

} // namespace tremolo::coupler
