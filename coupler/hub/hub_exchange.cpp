// The data side of the hub: READY, credits, frames, and who waits for whom.

#include "coupler/hub/hub.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/layout.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/format.h>
#include <stdexcept>
#include <utility>

namespace tremolo::coupler {

using nlohmann::json;

void Hub::take_ready(Participant& participant, const json& body) {
  auto faces = faces_from(body.at("faces"));
  const auto start_time = body.at("start_time").get<double>();
  const auto end_time = body.at("end_time").get<double>();
  ready_ = true;
  face_count_ = faces.size();
  next_domain_step_ = body.value("first_step", std::uint64_t{0});
  if (next_domain_step_ != (options_.resume ? options_.resume->step : 0))
    throw Error(fmt::format("READY for step {}, the run is to begin at step {}", next_domain_step_,
                            options_.resume ? options_.resume->step : 0));
  try {
    BoundaryExchange exchange(sources(), std::move(faces), start_time, end_time, options_.window_steps);
    exchange.release_before(options_.resume ? options_.resume->time : start_time);
    begin_observation(exchange, start_time, end_time);
    if (options_.mode == Mode::lockstep)
      exchange_.emplace(std::move(exchange));
  } catch (const std::invalid_argument& error) {
    fail(participant.expected.name, fmt::format("domain '{}': {}", participant.expected.name, error.what()));
    return;
  }
  if (exchange_)
    grant_new_credits();
}

void Hub::grant_new_credits() {
  for (const auto& credit : exchange_->new_credits())
    grant(participants_.at(credit.address.sender - 1), credit.address.field, credit.steps);
}

void Hub::take_credit(const json& body) {
  const auto number = body.at("source").get<std::uint32_t>();
  if (number == 0 || number > participants_.size())
    throw Error(fmt::format("CREDIT for participant {}, which does not exist", number));
  grant(participants_[number - 1], body.at("field").get<std::uint32_t>(),
        body.at("steps").get<std::uint64_t>());
}

void Hub::grant(Participant& source, std::uint32_t field, std::uint64_t steps) {
  if (field >= source.outlets.size())
    throw Error(
        fmt::format("CREDIT for field {} of '{}', which does not exist", field, source.expected.name));
  const bool idle = !owes_a_frame(source);
  auto& credit = source.outlets[field].credit;
  credit = std::max(credit, std::min(steps, source.fields[field].step_count));
  if (idle && owes_a_frame(source))
    source.pace.asked();
  send(source, {"CREDIT", {{"field", field}, {"steps", credit}}});
}

bool Hub::owes_a_frame(const Participant& source) const {
  for (std::size_t i = 0; i < source.outlets.size(); ++i) {
    const auto next_step = source.outlets[i].next_step;
    const auto credit = source.outlets[i].credit;
    const auto& field = source.fields[i];
    if (credit - next_step >= steps_per_frame(field, options_.window_steps) ||
        (next_step < credit && credit == field.step_count))
      return true;
  }
  return false;
}

void Hub::take_beat(Participant& participant, const json& body) {
  if (participant.expected.role == Role::domain) {
    take_progress(participant, body);
    return;
  }
  if (const auto done = body.value("done", 0.0); done > participant.work_done) {
    participant.work_done = done;
    participant.pace.advanced();
  }
}

void Hub::take_progress(Participant& domain, const json& body) {
  const Progress before =
      std::exchange(progress_, {body.at("stage").get<std::string>(), body.at("step").get<std::uint64_t>(),
                                body.at("time").get<double>(), body.at("end_time").get<double>()});
  if (options_.mode == Mode::window) {
    std::optional<BoundaryExchange::Missing> awaited;
    if (const auto waiting = body.find("waiting"); waiting != body.end())
      awaited = {waiting->at("source").get<std::string>(), waiting->at("field").get<std::string>(),
                 waiting->at("step").get<std::uint64_t>()};
    note_wait(awaited);
  }
  if (wait_ || progress_ != before)
    domain.pace.advanced();
}

void Hub::note_wait(const std::optional<BoundaryExchange::Missing>& awaited) {
  timeline_.turn_to(awaited ? waiting_for(awaited->source) : std::string(computing));
  if (!awaited)
    wait_.reset();
  else if (!wait_ || wait_->awaited != *awaited)
    wait_ = Wait{*awaited, Clock::now()};
}

void Hub::take_source_frame(Participant& source, zmq::message_t& raw) {
  const std::span<const std::byte> bytes(static_cast<const std::byte*>(raw.data()), raw.size());
  if (bytes.size() < frame_header_size)
    throw Error(fmt::format("a message of {} bytes is neither JSON nor a frame", bytes.size()));
  const auto field = claimed_origin(bytes).field;
  if (field >= source.fields.size())
    throw Error(fmt::format("a frame of field {}, but it serves {} fields", field, source.fields.size()));
  auto& outlet = source.outlets[field];
  const auto& description = source.fields[field];
  const auto decoded =
      decode(bytes, {.session = options_.session,
                     .sender = source.number,
                     .field = field,
                     .step = outlet.next_step,
                     .count = static_cast<std::uint32_t>(description.values_per_step()),
                     .most_steps = static_cast<std::uint32_t>(outlet.credit - outlet.next_step)});
  if (const auto* error = std::get_if<FrameError>(&decoded))
    throw Error(fmt::format("field '{}', step {}: {}", description.name, outlet.next_step, error->text));
  const auto& frame = std::get<Frame>(decoded);
  source.last_heard = Clock::now();
  source.pace.advanced();
  outlet.next_step += frame.header.steps;
  remember_last_step(outlet, description, frame);
  if (wait_ && wait_->awaited.source == source.expected.name && wait_->awaited.field == description.name &&
      wait_->awaited.step < outlet.next_step)
    wait_.reset();
  observe(bytes);
  if (domain().left) {
    dismiss_sources();
    return;
  }
  if (!exchange_) {
    // Byte for byte: the source's own checksum is checked again where the numbers are used.
    send_raw(domain().routing_id, raw);
    return;
  }
  exchange_->find({source.number, field})->history.append(frame.body);
  grant_new_credits();
  answer_pending_step();
}

void Hub::take_velocities(Participant& participant, std::span<const std::byte> bytes) {
  if (!ready_)
    throw Error("velocities before READY");
  const std::size_t count = layout::velocities(face_count_);
  const auto decoded = decode(bytes, {.session = options_.session,
                                      .sender = participant.number,
                                      .step = next_domain_step_,
                                      .count = static_cast<std::uint32_t>(count),
                                      .most_steps = options_.mode == Mode::lockstep ? 1U : ~0U});
  if (const auto* error = std::get_if<FrameError>(&decoded))
    throw Error(fmt::format("velocities of step {}: {}", next_domain_step_, error->text));
  const auto& frame = std::get<Frame>(decoded);
  participant.last_heard = Clock::now();
  participant.pace.advanced();
  next_domain_step_ += frame.header.steps;
  observe(bytes);
  wait_.reset();
  if (!exchange_)
    return;
  if (pending_)
    throw Error(
        fmt::format("step {} before the tractions of step {} were sent", frame.header.step, pending_->step));
  const auto [time] = frame.values<1>(0);
  pending_ = PendingStep{frame.header.step, time, std::vector<eq6::Vector>(face_count_)};
  for (std::size_t i = 0; i < face_count_; ++i) {
    const auto [vx, vy] = frame.values<2>(1 + 2 * i);
    pending_->v_domain[i] = {vx, vy};
  }
  answer_pending_step();
}

void Hub::answer_pending_step() {
  if (!pending_)
    return;
  note_wait(exchange_->missing(pending_->time));
  if (wait_)
    return;
  std::vector<eq6::FreeField> free_field(face_count_);
  std::vector<eq6::Vector> tractions(face_count_);
  exchange_->evaluate(pending_->time, pending_->v_domain, free_field, tractions);
  zmq::message_t raw(frame_header_size + layout::per_face * face_count_ * sizeof(double));
  const std::span bytes(static_cast<std::byte*>(raw.data()), raw.size());
  for (std::size_t i = 0; i < face_count_; ++i) {
    const auto& [v, s] = free_field[i];
    const std::array<double, layout::per_face> values{tractions[i].x, tractions[i].y, v.x, v.y,
                                                      s.xx,           s.yy,           s.xy};
    std::memcpy(bytes.data() + frame_header_size + i * sizeof values, values.data(), sizeof values);
  }
  seal({.session = options_.session,
        .step = pending_->step,
        .steps = 1,
        .count = static_cast<std::uint32_t>(layout::per_face * face_count_)},
       bytes);
  observe(bytes);
  send_raw(domain().routing_id, raw);
  pending_.reset();
  grant_new_credits();
}

} // namespace tremolo::coupler
