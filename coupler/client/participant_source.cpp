#include "coupler/participant.hpp"

#include "coupler/wire/error.hpp"
#include "coupler/wire/handshake/json_keys.hpp"
#include "coupler/wire/incoming.hpp"
#include "coupler/wire/plausible.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tremolo::coupler {

SourceClient::SourceClient(const ParticipantOptions& options, std::vector<FieldDescription> fields)
    : options_(options), fields_(std::move(fields)), connection_(options) {
  Message hello{"HELLO", {{"role", "source"}}};
  for (const auto& field : fields_) {
    validate(field);
    hello.body["fields"].push_back(to_json(field));
  }
  const Message welcome = connection_.introduce(std::move(hello));
  timeline_ = Timeline();
  outgoing_.resize(fields_.size());
  for (const auto& source : sources_from(welcome))
    if (source.number == connection_.number())
      fields_ = source.fields;
  if (fields_.size() != outgoing_.size())
    throw Error(fmt::format("WELCOME names {} fields of '{}', which serves {}", fields_.size(), options_.name,
                            outgoing_.size()));
}

void SourceClient::serve(const Fill& fill, const std::vector<PassTime>& passes) {
  while (!finished_) {
    // While there is work the socket is only looked at; without credit the source sleeps until the hub
    // speaks.
    take_messages(0.0);
    while (!finished_ && !send_frames(fill)) {
      if (connection_.hub_is_silent())
        connection_.fail(fmt::format("source '{}' waits for credit or BYE (deadline {} s); {}", options_.name,
                                     options_.deadlines.step, connection_.sign_of_life()));
      const auto waiting = timeline_.enter(waiting_for("domain"));
      waiting_.start();
      take_messages(0.5);
      waiting_.stop();
    }
  }
  say_bye(passes);
}

void SourceClient::beat(double done) {
  connection_.send({"BEAT", {{"stage", "computing"}, {"done", done}}});
}

void SourceClient::take_messages(double wait_s) {
  while (const auto incoming = connection_.receive(wait_s)) {
    wait_s = 0.0;
    if (!incoming->message)
      connection_.fail(fmt::format("source '{}' was sent a data frame", options_.name));
    const auto& [type, body] = *incoming->message;
    if (type == "BYE")
      finished_ = true;
    if (type == "CREDIT") {
      const auto field = whole_at(body, "field");
      if (field >= fields_.size())
        throw Error(fmt::format("CREDIT for field {} of '{}', which serves {}", field, options_.name,
                                fields_.size()));
      outgoing_[field].credit = std::min(whole_at(body, "steps"), fields_[field].step_count);
    }
  }
}

bool SourceClient::send_frames(const Fill& fill) {
  bool sent = false;
  for (std::size_t field = 0; field < fields_.size(); ++field) {
    const auto& out = outgoing_[field];
    const std::uint32_t most = fields_[field].steps_per_frame;
    const std::uint64_t room = out.credit - std::min(out.credit, out.next_step);
    const bool last = out.credit == fields_[field].step_count;
    if (room == 0 || (room < most && !last))
      continue;
    send_frame(field, static_cast<std::uint32_t>(std::min<std::uint64_t>(room, most)), fill);
    sent = true;
  }
  return sent;
}

void SourceClient::send_frame(std::size_t field, std::uint32_t steps, const Fill& fill) {
  const std::size_t count = fields_[field].values_per_step();
  const std::uint64_t first = outgoing_[field].next_step;
  FrameDraft draft(count * steps);
  const auto values = draft.values();
  filling_.start();
  for (std::uint32_t i = 0; i < steps; ++i)
    fill(field, first + i, values.subspan(i * count, count));
  filling_.stop();
  const auto exchanging = timeline_.enter(mapping);
  if (const auto wrong = implausible(fields_[field], first, std::as_bytes(values)))
    connection_.fail(fmt::format("source '{}', field '{}', {}", options_.name, fields_[field].name, *wrong));
  connection_.send({.session = connection_.session(),
                    .sender = connection_.number(),
                    .field = static_cast<std::uint32_t>(field),
                    .step = first,
                    .steps = steps,
                    .count = static_cast<std::uint32_t>(count)},
                   std::move(draft));
  outgoing_[field].next_step += steps;
}

void SourceClient::say_bye(const std::vector<PassTime>& passes) {
  std::vector<PassTime> all{{"fill", filling_.seconds()}};
  all.insert(all.end(), passes.begin(), passes.end());
  connection_.send({"BYE",
                    {{"passes", to_json(all)},
                     {"waiting", waiting_.seconds()},
                     {"timeline", to_json(timeline_.report())}}});
}

} // namespace tremolo::coupler
