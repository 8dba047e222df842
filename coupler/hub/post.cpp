#include "coupler/hub/post.hpp"

#include "coupler/wire/error.hpp"
#include "coupler/wire/sockets.hpp"

#include <array>
#include <cerrno>
#include <fmt/format.h>
#include <map>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace tremolo::coupler {

namespace {

std::optional<ClientGate> gate_of(zmq::context_t& context, const HubOptions& options) {
  if (options.keys.empty())
    return std::nullopt;
  std::map<std::string, std::string> allowed;
  for (const auto& participant : options.participants)
    if (participant.elsewhere || options.outer_endpoint.empty())
      if (const auto [other, fresh] =
              allowed.try_emplace(read_public_key(options.keys, participant.name), participant.name);
          !fresh)
        throw Error(
            fmt::format("{0}.public and {1}.public in {2} hold the same key: each participant needs its "
                        "own",
                        other->second, participant.name, options.keys.string()));
  return std::optional<ClientGate>(std::in_place, context, std::move(allowed));
}

zmq::socket_t listening(zmq::context_t& context, const std::string& endpoint, const HubOptions& options) {
  std::optional<CurveKeys> keys;
  if (!options.keys.empty() && options.outer_endpoint.empty())
    keys = read_keys(options.keys, hub_key);
  try {
    return bound_router(context, endpoint, keys);
  } catch (const zmq::error_t& error) {
    throw Error(fmt::format("the hub cannot listen at '{}': {}", endpoint, error.what()));
  }
}

/// An address that means all interfaces says nothing to another machine: this machine's name takes its place.
std::string as_told(const std::string& bound) {
  for (const std::string_view any : {"tcp://0.0.0.0:", "tcp://[::]:"})
    if (bound.starts_with(any)) {
      std::array<char, 256> name{};
      ::gethostname(name.data(), name.size() - 1);
      return fmt::format("tcp://{}:{}", name.data(), bound.substr(any.size()));
    }
  return bound;
}

} // namespace

std::string Letter::key_owner() {
  const char* owner = zmq_msg_gets(raw.handle(), "User-Id"); // as ClientGate has set it
  return owner == nullptr ? "" : owner;
}

Post::Post(zmq::context_t& context, const std::string& endpoint, const HubOptions& options)
    : gate_(gate_of(context, options)), socket_(listening(context, endpoint, options)),
      endpoint_(socket_.get(zmq::sockopt::last_endpoint)) {
  if (!options.outer_endpoint.empty())
    listen_to_others(options);
}

void Post::listen_to_others(const HubOptions& options) {
  if (options.keys.empty())
    throw Error(fmt::format("'{}' can be reached from other machines: it needs CURVE keys (--keys FOLDER; "
                            "`tremolo keygen` makes them)",
                            options.outer_endpoint));
  try {
    bind_also(socket_, options.outer_endpoint, read_keys(options.keys, hub_key));
  } catch (const zmq::error_t& error) {
    throw Error(fmt::format("the hub cannot listen at '{}': {}", options.outer_endpoint, error.what()));
  }
  outer_endpoint_ = as_told(socket_.get(zmq::sockopt::last_endpoint));
}

std::optional<Letter> Post::next() {
  if (gate_)
    gate_->answer();
  zmq::message_t routing_id;
  if (!socket_.recv(routing_id, zmq::recv_flags::dontwait))
    return std::nullopt;
  Letter letter{routing_id.to_string(), {}, 0};
  // All parts of a message come together.
  for (bool more = routing_id.more(); more && socket_.recv(letter.raw, zmq::recv_flags::dontwait).has_value();
       more = letter.raw.more())
    ++letter.parts;
  return letter;
}

bool Post::send(const std::string& routing_id, const Message& message) {
  const std::string text = to_text(message);
  zmq::message_t raw(text.data(), text.size());
  return forward(routing_id, raw);
}

bool Post::forward(const std::string& routing_id, zmq::message_t& raw) {
  require_fits(raw.size());
  try {
    socket_.send(zmq::const_buffer(routing_id.data(), routing_id.size()),
                 zmq::send_flags::sndmore | zmq::send_flags::dontwait);
    socket_.send(raw, zmq::send_flags::dontwait);
    return true;
  } catch (const zmq::error_t& error) {
    // It is gone: its BYE is on its way, or its process's end will be seen.
    if (error.num() != EHOSTUNREACH)
      throw;
    return false;
  }
}

} // namespace tremolo::coupler
