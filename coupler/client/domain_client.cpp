#include "coupler/participant.hpp"

#include "coupler/wire/error.hpp"
#include "coupler/wire/handshake/json_keys.hpp"
#include "coupler/wire/incoming.hpp"
#include "coupler/wire/layout.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>
#include <utility>

namespace tremolo::coupler {

namespace {

/// Between two signs of life; a few a second make a lively progress line and cost nothing.
constexpr double beat_interval_s = 0.2;

/// Velocities flow back in batches of about this size.
constexpr std::size_t batch_values = std::size_t{32} * 1024;
constexpr std::uint64_t batch_steps = 64;

} // namespace

DomainClient::DomainClient(const ParticipantOptions& options)
    : options_(options), connection_(options), last_beat_(Clock::now()) {
  const Message welcome = connection_.introduce({"HELLO", {{"role", "domain"}}});
  timeline_ = Timeline();
  mode_ = mode_from(text_at(welcome.body, "mode"));
  sources_ = sources_from(welcome);
}

void DomainClient::ready(const std::vector<ExchangedFace>& faces, double start_time, double end_time,
                         const std::optional<FirstStep>& first) {
  face_count_ = faces.size();
  free_field_.resize(face_count_);
  last_time_ = first ? first->time : start_time;
  next_step_ = batch_first_step_ = first ? first->step : 0;
  // Both modes build it, so that a mistake is reported by whoever finds it first, in the same words.
  try {
    exchange_.emplace(sources_, faces, start_time, end_time);
    exchange_->release_before(last_time_);
  } catch (const std::invalid_argument& error) {
    connection_.fail(fmt::format("domain '{}': {}", options_.name, error.what()));
  }
  connection_.send({"READY",
                    {{"faces", to_json(faces)},
                     {"start_time", start_time},
                     {"end_time", end_time},
                     {"first_step", next_step_}}});
  if (mode_ == Mode::window)
    grant_credits();
}

DomainClient::Exchanged DomainClient::exchange(std::uint64_t step, double time,
                                               std::span<const eq6::Vector> v_domain) {
  const auto exchanging = timeline_.enter(mapping);
  check_step(step, time, v_domain);
  append_velocities(time, v_domain);
  if (mode_ == Mode::lockstep) {
    send_velocities();
    wait_for_hub(step, v_domain);
  } else {
    // Messages are read when they are needed; until then they stay in the socket, bounded by the credit.
    if (exchange_->missing(time))
      wait_for_sources(step, time);
    exchange_->read(time, free_field_);
    grant_credits();
    if (batch_.size() >= batch_values || next_step_ - batch_first_step_ >= batch_steps)
      send_velocities();
  }
  return {free_field_, waiting_.seconds()};
}

void DomainClient::check_step(std::uint64_t step, double time, std::span<const eq6::Vector> v_domain) {
  if (!exchange_)
    throw std::logic_error("exchange() before ready()");
  if (step != next_step_ || v_domain.size() != face_count_)
    throw std::logic_error(fmt::format("exchange(): step {} with {} faces, expected step {} with {}", step,
                                       v_domain.size(), next_step_, face_count_));
  if (!(time >= last_time_))
    connection_.fail(fmt::format("domain '{}', step {}: time {} s lies before the last one, {} s",
                                 options_.name, step, time, last_time_));
  for (std::size_t i = 0; i < v_domain.size(); ++i)
    if (!std::isfinite(v_domain[i].x) || !std::isfinite(v_domain[i].y))
      connection_.fail(fmt::format("domain '{}', step {}: the velocity of face {} is ({}, {})", options_.name,
                                   step, i, v_domain[i].x, v_domain[i].y));
  next_step_ = step + 1;
  last_time_ = time;
}

std::optional<Incoming> DomainClient::await(const std::string& whom) {
  const auto waiting = timeline_.enter(waiting_for(whom));
  return connection_.receive(beat_interval_s);
}

void DomainClient::wait_for_sources(std::uint64_t step, double time) {
  waiting_.start();
  while (const auto missing = exchange_->missing(time)) {
    if (auto incoming = await(missing->source)) {
      if (!incoming->message) {
        take_source_frame(incoming->frame());
        grant_credits();
      }
      continue;
    }
    beat(missing);
    check_hub(fmt::format("step {} of '{}' from source '{}' (own step {})", missing->step, missing->field,
                          missing->source, step));
  }
  waiting_.stop();
}

void DomainClient::wait_for_hub(std::uint64_t step, std::span<const eq6::Vector> v_domain) {
  waiting_.start();
  for (bool arrived = false; !arrived;) {
    if (auto incoming = await("hub")) {
      arrived = !incoming->message;
      if (arrived)
        take_tractions(step, incoming->frame(), v_domain);
      continue;
    }
    beat(std::nullopt);
    check_hub(fmt::format("the tractions of step {}", step));
  }
  waiting_.stop();
}

void DomainClient::check_hub(const std::string& awaited) {
  if (connection_.hub_is_silent())
    connection_.fail(fmt::format("domain '{}' waits for {} (deadline {} s); {}", options_.name, awaited,
                                 options_.deadlines.step, connection_.sign_of_life()));
}

void DomainClient::take_tractions(std::uint64_t step, std::span<const std::byte> bytes,
                                  std::span<const eq6::Vector> v_domain) {
  const auto decoded = decode(bytes, {.session = connection_.session(),
                                      .step = step,
                                      .count = static_cast<std::uint32_t>(layout::per_face * face_count_),
                                      .most_steps = 1});
  if (const auto* error = std::get_if<FrameError>(&decoded))
    connection_.fail(
        fmt::format("domain '{}' refuses the tractions of step {}: {}", options_.name, step, error->text));
  const auto& frame = std::get<Frame>(decoded);
  for (std::size_t i = 0; i < face_count_; ++i) {
    const auto value = frame.values<layout::per_face>(i * layout::per_face);
    free_field_[i] = {{value[2], value[3]}, {value[4], value[5], value[6]}};
    const eq6::Vector here = exchange_->faces()[i].traction(v_domain[i], free_field_[i]);
    if (here.x != value[0] || here.y != value[1])
      connection_.fail(
          fmt::format("domain '{}', step {}: the hub's traction on face {} is {:.17g}, {:.17g} Pa, Eq. (6) "
                      "here gives {:.17g}, {:.17g} Pa: the programs of this run are of different builds",
                      options_.name, step, i, value[0], value[1], here.x, here.y));
  }
}

void DomainClient::take_source_frame(std::span<const std::byte> bytes) {
  const auto [sender, field] = claimed_origin(bytes);
  auto* inlet = exchange_ ? exchange_->find({sender, field}) : nullptr;
  if (inlet == nullptr)
    connection_.fail(fmt::format("domain '{}' was sent field {} of participant {}, which it did not ask for",
                                 options_.name, field, sender));
  auto& history = inlet->history;
  const auto decoded =
      decode(bytes, {.session = connection_.session(),
                     .sender = sender,
                     .field = field,
                     .step = history.next_step(),
                     .count = static_cast<std::uint32_t>(history.field().values_per_step()),
                     .most_steps = static_cast<std::uint32_t>(history.credit() - history.next_step())});
  if (const auto* error = std::get_if<FrameError>(&decoded))
    connection_.fail(fmt::format("domain '{}' refuses a frame of source '{}', field '{}': {}", options_.name,
                                 inlet->source, history.field().name, error->text));
  history.append(std::get<Frame>(decoded).body);
}

void DomainClient::append_velocities(double time, std::span<const eq6::Vector> v_domain) {
  batch_.push_back(time);
  for (const auto& v : v_domain) {
    batch_.push_back(v.x);
    batch_.push_back(v.y);
  }
}

void DomainClient::send_velocities() {
  if (batch_.empty())
    return;
  FrameDraft draft(batch_.size());
  std::ranges::copy(batch_, draft.values().begin());
  connection_.send({.session = connection_.session(),
                    .sender = connection_.number(),
                    .step = batch_first_step_,
                    .steps = static_cast<std::uint32_t>(next_step_ - batch_first_step_),
                    .count = static_cast<std::uint32_t>(layout::velocities(face_count_))},
                   std::move(draft));
  batch_.clear();
  batch_first_step_ = next_step_;
}

void DomainClient::grant_credits() {
  for (const auto& credit : exchange_->new_credits())
    connection_.send(
        {"CREDIT",
         {{"source", credit.address.sender}, {"field", credit.address.field}, {"steps", credit.steps}}});
}

void DomainClient::progress(const std::string& stage, std::uint64_t step, double time, double end_time,
                            std::optional<double> residual) {
  stage_ = stage;
  stage_step_ = step;
  stage_time_ = time;
  stage_end_time_ = end_time;
  stage_residual_ = residual;
  if (seconds_since(last_beat_) < beat_interval_s)
    return;
  drain();
  beat(std::nullopt);
}

void DomainClient::beat(const std::optional<FaceExchange::Missing>& awaited) {
  last_beat_ = Clock::now();
  Message message{
      "BEAT",
      {{"stage", stage_}, {"step", stage_step_}, {"time", stage_time_}, {"end_time", stage_end_time_}}};
  if (stage_residual_)
    message.body["residual"] = *stage_residual_;
  if (awaited)
    message.body["waiting"] = {
        {"source", awaited->source}, {"field", awaited->field}, {"step", awaited->step}};
  connection_.send(message);
}

void DomainClient::drain() {
  while (const auto incoming = connection_.receive(0.0))
    if (!incoming->message)
      take_source_frame(incoming->frame());
}

void DomainClient::finish(const std::vector<PassTime>& passes, double particle_updates) {
  send_velocities();
  connection_.take_leave({"BYE",
                          {{"passes", to_json(passes)},
                           {"waiting", waiting_.seconds()},
                           {"timeline", to_json(timeline_.report())},
                           {"particle_updates", particle_updates}}});
}

} // namespace tremolo::coupler
