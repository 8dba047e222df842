#pragma once

#include "coupler/wire/handshake/messages.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <zmq.hpp>

namespace tremolo::coupler {

/// An incoming control message or data frame.
struct Incoming {
  std::optional<Message> message;
  zmq::message_t raw;

  [[nodiscard]] std::span<const std::byte> frame() const {
    return {static_cast<const std::byte*>(raw.data()), raw.size()};
  }
};

} // namespace tremolo::coupler
