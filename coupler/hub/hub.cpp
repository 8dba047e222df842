#include "coupler/hub/hub.hpp"

#include "base/text/printable.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/handshake/json_keys.hpp"
#include "coupler/wire/sockets.hpp"

#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <utility>

namespace tremolo::coupler {

using nlohmann::json;

namespace {

constexpr double beat_interval_s = 0.25;

} // namespace

Hub::Hub(zmq::context_t& context, const std::string& endpoint, HubOptions options)
    : options_(std::move(options)), notes_(options_.note), roster_(options_.participants),
      post_(context, endpoint, options_), admission_(options_, roster_, post_),
      watch_(options_.deadlines, roster_, notes_), keeper_(options_, roster_),
      routing_(options_, roster_, post_, watch_, keeper_), last_beat_(Clock::now()) {}

void Hub::take_messages() {
  while (auto letter = post_.next())
    if (!failure_)
      take(*letter);
}

void Hub::take(Letter& letter) {
  auto* participant = roster_.at_connection(letter.routing_id);
  try {
    participant == nullptr ? take_from_stranger(letter) : take_from(*participant, letter);
  } catch (const Fault& fault) {
    fail(fault.failure());
  } catch (const std::exception& error) {
    if (participant == nullptr)
      refuse(letter.routing_id, error.what());
    else
      fail(Failure{participant->expected.name,
                   fmt::format("{} '{}' sent nonsense: {}", name(participant->expected.role),
                               participant->expected.name, error.what())});
  }
}

void Hub::take_from(Participant& participant, Letter& letter) {
  require_one_part(letter.parts);
  if (looks_like_message(letter.bytes()))
    take_message(participant, parse_message(letter.bytes()));
  else if (participant.is_domain())
    routing_.take_velocities(participant, letter.bytes());
  else
    routing_.take_source_frame(participant, letter.raw);
}

void Hub::take_from_stranger(Letter& letter) {
  require_one_part(letter.parts);
  if (!looks_like_message(letter.bytes())) {
    notes_.show_of_stranger(
        letter.routing_id,
        fmt::format("ignored {} bytes from a stranger that has not said HELLO", letter.raw.size()));
    return;
  }
  const auto [type, body] = parse_message(letter.bytes());
  const auto* ushered = roster_.ushered_by(letter.routing_id);
  if (type == "JOIN")
    admission_.take_join(letter, body);
  else if (type == "HELLO")
    take_hello(letter, body);
  else if (type == "ABORT" && ushered != nullptr && !ushered->left)
    throw Fault({ushered->expected.name, text_or(body, "reason", "no reason given")});
  else
    throw Refusal(fmt::format("{} before HELLO", type));
}

void Hub::take_hello(Letter& letter, const json& hello) {
  const auto& participant = admission_.take_hello(letter, hello);
  watch_.heard(participant);
  if (!participant.is_domain())
    keeper_.restore(participant);
  if (roster_.is_complete())
    welcome_all();
}

void Hub::welcome_all() {
  welcomed_ = true;
  watch_.begin();
  json list = json::array();
  for (const auto& source : roster_.sources())
    list.push_back(to_json(source));
  for (const auto& participant : roster_.all())
    post_.send(
        participant.routing_id,
        {"WELCOME", {{"number", participant.number}, {"mode", name(options_.mode)}, {"sources", list}}});
}

void Hub::take_message(Participant& participant, const Message& message) {
  const auto& [type, body] = message;
  const bool from_domain = participant.is_domain();
  watch_.heard(participant);
  if (type == "ABORT")
    throw Fault({participant.expected.name, text_or(body, "reason", "no reason given")});
  if (type == "BEAT")
    take_beat(participant, body);
  else if (type == "BYE" && (from_domain || routing_.has_dismissed()))
    take_bye(participant, body);
  else if (type == "READY" && from_domain && welcomed_ && !routing_.is_ready())
    routing_.take_ready(body);
  else if (type == "CREDIT" && from_domain && routing_.is_ready() && options_.mode == Mode::window)
    routing_.take_credit(body);
  else if (type == "CHECKPOINT" && from_domain && routing_.is_ready())
    take_checkpoint(body);
  else
    throw Error(fmt::format("{} was not expected now", type));
}

void Hub::take_beat(Participant& participant, const json& body) {
  if (participant.is_domain()) {
    routing_.take_wait(body);
    watch_.domain_beats(participant, body);
  } else {
    watch_.source_beats(participant, body);
  }
}

void Hub::take_checkpoint(const json& body) {
  const auto step = whole_at(body, "step");
  const double time = number_at(body, "time");
  if (step != routing_.next_domain_step())
    throw Error(fmt::format("CHECKPOINT at step {}, its velocities have come up to step {}", step,
                            routing_.next_domain_step()));
  if (options_.checkpoints.folder.empty())
    throw Error("CHECKPOINT in a run that makes none");
  try {
    keeper_.complete(step, time);
  } catch (const std::exception& error) {
    notes_.show(fmt::format("warning: no checkpoint at step {}: {}", step, message_of(error)));
  }
  post_.send(roster_.domain().routing_id, {"CHECKPOINT", {{"step", step}}});
}

void Hub::take_bye(Participant& participant, const json& body) {
  ParticipantReport report{
      .passes = passes_from(list_at(body, "passes")), .waiting = number_at(body, "waiting"), .timeline = {}};
  if (body.contains("particle_updates"))
    report.particle_updates = number_at(body, "particle_updates");
  if (const auto timeline = body.find("timeline"); timeline != body.end())
    report.timeline = timeline_from(*timeline);
  if (participant.is_domain())
    report.timeline.resolve_waits("hub", watch_.waits());
  participant.left = true;
  reports_[participant.expected.name] = std::move(report);
  if (participant.is_domain()) {
    watch_.domain_waits_for(std::nullopt);
    post_.send(participant.routing_id, {"BYE"});
    routing_.end();
  }
}

bool Hub::finished() const {
  return std::ranges::all_of(roster_.all(), &Participant::left);
}

bool Hub::has_left(const std::string& participant) const {
  return reports_.contains(participant);
}

void Hub::tick() {
  // Nobody is waited for after the sources' dismissal, and a dismissed source is sent nothing more: it closes
  // its connection behind its BYE. A BEAT that came to its machine later would be answered with a reset
  // there, and a BYE that the line had lost would not be sent again.
  if (failure_ || routing_.has_dismissed())
    return;
  if (!welcomed_) {
    fail(watch_.absent());
    return;
  }
  fail(watch_.overdue(routing_.owed_by_domain()));
  if (seconds_since(last_beat_) < beat_interval_s)
    return;
  last_beat_ = Clock::now();
  for (const auto& participant : roster_.all())
    if (!participant.left)
      fail(watch_.lost(participant, post_.send(participant.routing_id, {"BEAT"})));
}

void Hub::abort(const std::string& reason) {
  // Participants that have already left receive nothing.
  for (const auto& participant : roster_.all())
    if (!participant.routing_id.empty() && !participant.left)
      post_.send(participant.routing_id, {"ABORT", {{"reason", reason}}});
}

void Hub::refuse(const std::string& routing_id, const std::string& reason) {
  notes_.show_of_stranger(routing_id, "refused: " + reason);
  post_.send(routing_id, {"REFUSE", {{"reason", reason}}});
}

void Hub::fail(const std::optional<Failure>& failure) {
  if (failure && !failure_)
    failure_ = Failure{failure->participant, printable(failure->text), failure->refuses_checkpoint};
}

} // namespace tremolo::coupler
