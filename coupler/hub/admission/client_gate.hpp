#pragma once

// Lets in the participants of a run and nobody else: answers ZeroMQ's question, before a CURVE connection
// stands, whether a client's key is known (ZAP, https://rfc.zeromq.org/spec/27).

#include <map>
#include <string>
#include <zmq.hpp>

namespace tremolo::coupler {

class ClientGate {
public:
  /// Create the gate before binding the socket that it guards.
  /// @param allowed public keys, Z85, and the names of their owners: what comes over such a connection has
  /// the name as its "User-Id"
  ClientGate(zmq::context_t& context, std::map<std::string, std::string> allowed);

  /// Answers all questions that wait; never blocks.
  void answer();

private:
  std::map<std::string, std::string> allowed_;
  zmq::socket_t socket_;
};

} // namespace tremolo::coupler
