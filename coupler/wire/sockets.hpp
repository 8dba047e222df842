#pragma once

// Every ZeroMQ option that the project sets, in one place, with its reason.

#include "coupler/wire/keys.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <zmq.hpp>

namespace tremolo::coupler {

/// Bytes that a message may have. libzmq drops the connection of whoever sends more, and the sender does not
/// learn of it: so senders look at it first.
inline constexpr std::int64_t largest_message = std::int64_t{64} << 20;

/// A context for so many connections.
/// @throws Error if the process may not open as many files: libzmq would end it without a word
zmq::context_t new_context(std::size_t connections);

/// @throws Error for a message that is larger
void require_fits(std::size_t bytes);

/// @throws Error for a message of several parts, e.g. with an empty one in front as REQ sockets send it
void require_one_part(std::size_t parts);

/// Whether only processes of this machine can reach an address: ipc, and tcp on the loopback
/// interface by its number (a name may resolve to anything).
bool is_local(std::string_view endpoint);

/// @param keys of the hub; without them only a local address is bound
/// @throws Error naming an address that is not local where there are no keys; zmq::error_t if the endpoint
/// cannot be bound
zmq::socket_t bound_router(zmq::context_t& context, const std::string& endpoint,
                           const std::optional<CurveKeys>& keys = {});

/// Lets a bound router also listen at another address, to which only owners of keys are admitted. Its earlier
/// addresses are unaffected: options apply to addresses bound after them.
/// @throws zmq::error_t if the endpoint cannot be bound
void bind_also(zmq::socket_t& router, const std::string& endpoint, const CurveKeys& keys);

/// Connects in the background; whether anybody answers shows in the handshake.
/// @throws as bound_router
zmq::socket_t connected_dealer(zmq::context_t& context, const std::string& endpoint,
                               const std::optional<CurveKeys>& keys = {});

/// Waits until the socket has a message, at most wait_s.
bool wait_readable(zmq::socket_t& socket, double wait_s);

} // namespace tremolo::coupler
