#include "coupler/wire/sockets.hpp"

#include "coupler/wire/error.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <sys/resource.h>

namespace tremolo::coupler {

namespace {

void set_common_options(zmq::socket_t& socket) {
  // The default, -1, lets the context's destructor hang for ever over one message that nobody takes.
  socket.set(zmq::sockopt::linger, 500);
  // The high-water marks count messages. What we queue is bounded in bytes by the credit that the receiver
  // gave, in steps of known size; a bound in messages would fail an exchange of many small frames.
  socket.set(zmq::sockopt::sndhwm, 0);
  // A connection that says nothing we understand is closed after this time (ms; default 30 s).
  socket.set(zmq::sockopt::handshake_ivl, 3000);
  // A forged length must not make us allocate gigabytes. libzmq fixes the limit when a connection is made,
  // before anything is negotiated: so it is the same for all, and HELLO is refused where a step is larger.
  socket.set(zmq::sockopt::maxmsgsize, largest_message);
  // No ZMTP heartbeats: they are answered by libzmq's own thread while a solver hangs, and they would drop
  // the connection, with all that is queued on it, of a process that is stopped and continued.
}

void require_local_or_keys(const std::string& endpoint, const std::optional<CurveKeys>& keys) {
  if (!keys && !is_local(endpoint))
    throw Error(fmt::format("'{}' can be reached from other machines: it needs CURVE keys (--keys FOLDER; "
                            "`tremolo keygen` makes them)",
                            endpoint));
}

} // namespace

zmq::context_t new_context(std::size_t connections) {
  // Standard streams, libzmq's threads and sockets, logs, results; and a connection and a log each.
  const rlim_t needed = 20 + 2 * connections;
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) == 0 && limit.rlim_cur < needed) {
    limit.rlim_cur = limit.rlim_max;
    if (limit.rlim_max < needed || ::setrlimit(RLIMIT_NOFILE, &limit) != 0)
      throw Error(fmt::format("this process may open {} files, it needs {}: raise `ulimit -n`",
                              limit.rlim_max, needed));
  }
  return zmq::context_t(1);
}

void require_fits(std::size_t bytes) {
  if (bytes > static_cast<std::size_t>(largest_message))
    throw Error(
        fmt::format("a message of {} bytes is larger than what is taken, {}", bytes, largest_message));
}

void require_one_part(std::size_t parts) {
  if (parts != 1)
    throw Error(
        fmt::format("a message of {} parts, expected one without an empty part in front of it", parts));
}

bool is_local(std::string_view endpoint) {
  if (endpoint.starts_with("ipc://") || endpoint.starts_with("tcp://[::1]:"))
    return true;
  constexpr std::string_view loopback = "tcp://127.";
  return endpoint.starts_with(loopback) &&
         endpoint.substr(loopback.size()).find_first_not_of("0123456789.") ==
             endpoint.rfind(':') - loopback.size();
}

zmq::socket_t bound_router(zmq::context_t& context, const std::string& endpoint,
                           const std::optional<CurveKeys>& keys) {
  require_local_or_keys(endpoint, keys);
  zmq::socket_t socket(context, zmq::socket_type::router);
  set_common_options(socket);
  // Sending to a participant that is gone is an error, not a silent drop.
  socket.set(zmq::sockopt::router_mandatory, true);
  // Limit on the messages that one stranger can queue; the hub reads messages at once and never blocks.
  socket.set(zmq::sockopt::rcvhwm, 1000);
  if (keys)
    bind_also(socket, endpoint, *keys);
  else
    socket.bind(endpoint);
  return socket;
}

void bind_also(zmq::socket_t& router, const std::string& endpoint, const CurveKeys& keys) {
  router.set(zmq::sockopt::curve_server, true);
  router.set(zmq::sockopt::curve_secretkey, keys.own_secret);
  // Without a domain libzmq asks nobody (client_gate.hpp) and lets every key in.
  router.set(zmq::sockopt::zap_domain, std::string("tremolo"));
  router.bind(endpoint);
}

zmq::socket_t connected_dealer(zmq::context_t& context, const std::string& endpoint,
                               const std::optional<CurveKeys>& keys) {
  require_local_or_keys(endpoint, keys);
  zmq::socket_t socket(context, zmq::socket_type::dealer);
  set_common_options(socket);
  // Nothing is queued for a hub that is not connected: "sent" means there was a connection.
  socket.set(zmq::sockopt::immediate, true);
  // Bounded by this participant's own credit.
  socket.set(zmq::sockopt::rcvhwm, 0);
  if (keys) {
    // The time that a slow network has to take a BYE; the kernel sends it again where it is lost, also when
    // this process has ended, as long as nothing more comes from the hub (Hub::tick).
    socket.set(zmq::sockopt::linger, 2000);
    socket.set(zmq::sockopt::curve_serverkey, keys->hub_public);
    socket.set(zmq::sockopt::curve_publickey, keys->own_public);
    socket.set(zmq::sockopt::curve_secretkey, keys->own_secret);
  }
  socket.connect(endpoint);
  return socket;
}

bool wait_readable(zmq::socket_t& socket, double wait_s) {
  std::array<zmq::pollitem_t, 1> items{{{socket.handle(), 0, ZMQ_POLLIN, 0}}};
  const auto ms = static_cast<std::int64_t>(std::ceil(std::max(wait_s, 0.0) * 1000.0));
  return zmq::poll(items.data(), items.size(), std::chrono::milliseconds(ms)) > 0;
}

} // namespace tremolo::coupler
