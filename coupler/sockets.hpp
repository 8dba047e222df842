#pragma once

// Every ZeroMQ option that the project sets, in one place, with its reason.

#include <string>
#include <zmq.hpp>

namespace tremolo::coupler {

/// @throws zmq::error_t if the endpoint cannot be bound
zmq::socket_t bound_router(zmq::context_t& context, const std::string& endpoint);

/// Connects in the background; whether anybody answers shows in the handshake.
zmq::socket_t connected_dealer(zmq::context_t& context, const std::string& endpoint);

/// Waits until the socket has a message, at most wait_s.
bool wait_readable(zmq::socket_t& socket, double wait_s);

} // namespace tremolo::coupler
