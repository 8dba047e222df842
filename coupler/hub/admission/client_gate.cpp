#include "coupler/hub/admission/client_gate.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tremolo::coupler {

namespace {

/// Frames of a question: version, request id, domain, address, identity, mechanism, key.
constexpr std::size_t request_id = 1;
constexpr std::size_t mechanism = 5;
constexpr std::size_t key = 6;

std::string z85(const std::string& binary) {
  std::array<char, 41> text{};
  const bool is_key = binary.size() == 32;
  if (is_key)
    zmq_z85_encode(text.data(), reinterpret_cast<const std::uint8_t*>(binary.data()), binary.size());
  return text.data();
}

} // namespace

ClientGate::ClientGate(zmq::context_t& context, std::map<std::string, std::string> allowed)
    : allowed_(std::move(allowed)), socket_(context, zmq::socket_type::router) {
  socket_.set(zmq::sockopt::linger, 0);
  socket_.bind("inproc://zeromq.zap.01");
}

void ClientGate::answer() {
  for (zmq::message_t peer; socket_.recv(peer, zmq::recv_flags::dontwait);) {
    std::vector<std::string> question; // behind an empty frame
    for (zmq::message_t part; socket_.recv(part, zmq::recv_flags::dontwait);) {
      question.push_back(part.to_string());
      if (!part.more())
        break;
    }
    question.erase(question.begin());
    if (question.size() <= mechanism)
      continue;
    const auto owner = question[mechanism] == "CURVE" && question.size() > key
                           ? allowed_.find(z85(question[key]))
                           : allowed_.end();
    const bool known = owner != allowed_.end();
    const std::array<std::string_view, 8> answer{peer.to_string_view(),
                                                 "",
                                                 "1.0",
                                                 question[request_id],
                                                 known ? "200" : "400",
                                                 known ? "" : "unknown key",
                                                 known ? std::string_view(owner->second) : "",
                                                 ""};
    for (std::size_t i = 0; i < answer.size(); ++i)
      socket_.send(zmq::buffer(answer[i]),
                   i + 1 < answer.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
  }
}

} // namespace tremolo::coupler
