// What the hub does for somebody who looks on (exchange_observer.hpp).

#include "coupler/hub/hub.hpp"

#include <exception>

namespace tremolo::coupler {

void Hub::begin_observation(const BoundaryExchange& exchange, double start_time, double end_time) {
  if (options_.observer == nullptr)
    return;
  ExchangeStart start{.session = options_.session,
                      .mode = options_.mode,
                      .window_steps = options_.window_steps,
                      .sources = sources(),
                      .needed_steps = {},
                      .domain = domain().expected.name,
                      .domain_number = domain().number,
                      .faces = exchange.faces(),
                      .start_time = start_time,
                      .end_time = end_time};
  for (auto& participant : participants_)
    participant.needed.assign(participant.fields.size(), 0);
  for (const auto& inlet : exchange.inlets())
    participants_[inlet.address.sender - 1].needed[inlet.address.field] =
        inlet.history.needed_until(end_time);
  for (const auto& participant : participants_)
    if (participant.expected.role == Role::source)
      start.needed_steps.push_back(participant.needed);
  try {
    options_.observer->begin(start);
  } catch (const std::exception& error) {
    fail("", error.what());
  }
}

void Hub::observe(std::span<const std::byte> bytes) {
  if (options_.observer == nullptr)
    return;
  try {
    options_.observer->frame(bytes);
  } catch (const std::exception& error) {
    fail("", error.what());
  }
}

/// The domain stops a little before the end. A source may then lack the last steps up to it, and a recording
/// would hold less than a run asks for when it is served again.
void Hub::request_needed_steps() {
  for (auto& source : participants_)
    for (std::uint32_t f = 0; f < source.needed.size(); ++f) {
      const std::uint64_t credit = source.outlets[f].credit;
      const std::uint64_t frame = steps_per_frame(source.fields[f], options_.window_steps);
      if (source.needed[f] > credit)
        grant(source, f, credit + (source.needed[f] - credit + frame - 1) / frame * frame);
    }
}

void Hub::dismiss_sources() {
  if (dismissed_)
    return;
  for (const auto& source : participants_)
    for (std::size_t f = 0; f < source.needed.size(); ++f)
      if (source.outlets[f].next_step < source.needed[f])
        return;
  dismissed_ = true;
  for (auto& source : participants_)
    if (!source.left)
      send(source, {"BYE"});
}

} // namespace tremolo::coupler
