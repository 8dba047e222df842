#pragma once

// Lets in the participants of a run and nobody else: answers ZeroMQ's question, before a CURVE connection
// stands, whether a client's key is known (ZAP, https://rfc.zeromq.org/spec/27).

#include <string>
#include <vector>
#include <zmq.hpp>

namespace tremolo::coupler {

class ClientGate {
public:
  /// To be made before the socket it guards is bound.
  /// @param allowed public keys, Z85
  ClientGate(zmq::context_t& context, std::vector<std::string> allowed);

  /// Answers all questions that wait; never blocks.
  void answer();

private:
  std::vector<std::string> allowed_;
  zmq::socket_t socket_;
};

} // namespace tremolo::coupler
