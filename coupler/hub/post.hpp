#pragma once

// The hub's socket: whole messages come in, messages go out to a connection. It never blocks. Where the run
// has keys, only their owners get through.

#include "coupler/hub/admission/client_gate.hpp"
#include "coupler/hub/hub_options.hpp"
#include "coupler/wire/handshake/messages.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <zmq.hpp>

namespace tremolo::coupler {

/// A message that has come from one connection.
struct Letter {
  std::string routing_id;
  zmq::message_t raw;    ///< its last part
  std::size_t parts = 0; ///< of the message: a participant sends one

  [[nodiscard]] std::span<const std::byte> bytes() const {
    return {static_cast<const std::byte*>(raw.data()), raw.size()};
  }
  /// Owner of the CURVE key that the connection presented; empty over ipc.
  [[nodiscard]] std::string key_owner();
};

class Post {
public:
  /// @throws Error if an endpoint cannot be bound or keys are missing
  Post(zmq::context_t& context, const std::string& endpoint, const HubOptions& options);

  [[nodiscard]] const std::string& endpoint() const { return endpoint_; }
  [[nodiscard]] const std::string& outer_endpoint() const { return outer_endpoint_; }
  [[nodiscard]] zmq::socket_ref socket() { return socket_; }

  /// The next message that waits.
  std::optional<Letter> next();

  /// @returns whether the connection is still there
  bool send(const std::string& routing_id, const Message& message);
  bool forward(const std::string& routing_id, zmq::message_t& raw);

private:
  void listen_to_others(const HubOptions& options);

  std::optional<ClientGate> gate_; ///< before the socket it guards
  zmq::socket_t socket_;
  std::string endpoint_;
  std::string outer_endpoint_;
};

} // namespace tremolo::coupler
