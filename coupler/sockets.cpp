#include "coupler/sockets.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>

namespace tremolo::coupler {

namespace {

void set_common_options(zmq::socket_t& socket) {
  // The default, -1, lets the context's destructor hang for ever over one message that nobody takes.
  socket.set(zmq::sockopt::linger, 500);
  // Messages, not bytes. The credits bound what is in flight long before; this bounds what a stranger can
  // pile up.
  socket.set(zmq::sockopt::sndhwm, 1000);
  socket.set(zmq::sockopt::rcvhwm, 1000);
  // A connection that says nothing we understand is closed after this time (ms; default 30 s).
  socket.set(zmq::sockopt::handshake_ivl, 3000);
  // No message of ours comes near; a forged length must not make us allocate gigabytes.
  socket.set(zmq::sockopt::maxmsgsize, std::int64_t{256} << 20);
}

} // namespace

zmq::socket_t bound_router(zmq::context_t& context, const std::string& endpoint) {
  zmq::socket_t socket(context, zmq::socket_type::router);
  set_common_options(socket);
  // Sending to a participant that is gone is an error, not a silent drop.
  socket.set(zmq::sockopt::router_mandatory, true);
  socket.bind(endpoint);
  return socket;
}

zmq::socket_t connected_dealer(zmq::context_t& context, const std::string& endpoint) {
  zmq::socket_t socket(context, zmq::socket_type::dealer);
  set_common_options(socket);
  // Nothing is queued for a hub that is not connected: "sent" means there was a connection.
  socket.set(zmq::sockopt::immediate, true);
  socket.connect(endpoint);
  return socket;
}

bool wait_readable(zmq::socket_t& socket, double wait_s) {
  std::array<zmq::pollitem_t, 1> items{{{socket.handle(), 0, ZMQ_POLLIN, 0}}};
  const auto ms = static_cast<std::int64_t>(std::ceil(std::max(wait_s, 0.0) * 1000.0));
  return zmq::poll(items.data(), items.size(), std::chrono::milliseconds(ms)) > 0;
}

} // namespace tremolo::coupler
