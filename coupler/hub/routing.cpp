#include "coupler/hub/routing.hpp"

#include "coupler/hub/progress.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/frame.hpp"
#include "coupler/wire/handshake/json_keys.hpp"
#include "coupler/wire/layout.hpp"
#include "coupler/wire/plausible.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/format.h>
#include <stdexcept>
#include <utility>

namespace tremolo::coupler {

using nlohmann::json;

std::vector<Routing::Outlet>& Routing::of(const Participant& source) {
  auto& outlets = outlets_[source.index()];
  outlets.resize(source.fields.size());
  return outlets;
}

std::string Routing::owed_by_domain() const {
  return ready_ ? fmt::format("the velocities of step {}", next_domain_step_) : "READY";
}

void Routing::take_ready(const json& body) {
  auto faces = faces_from(list_at(body, "faces"));
  const double start_time = number_at(body, "start_time");
  const double end_time = number_at(body, "end_time");
  const std::uint64_t first_step = options_.resume ? options_.resume->step : 0;
  ready_ = true;
  face_count_ = faces.size();
  next_domain_step_ = body.contains("first_step") ? whole_at(body, "first_step") : 0;
  if (next_domain_step_ != first_step)
    throw Error(
        fmt::format("READY for step {}, the run is to begin at step {}", next_domain_step_, first_step));
  try {
    FaceExchange exchange(roster_.sources(), std::move(faces), start_time, end_time);
    exchange.release_before(options_.resume ? options_.resume->time : start_time);
    begin_observation(exchange, start_time, end_time);
    if (options_.mode == Mode::lockstep)
      exchange_.emplace(std::move(exchange));
  } catch (const std::invalid_argument& error) {
    const auto& domain = roster_.domain().expected.name;
    throw Fault({domain, fmt::format("domain '{}': {}", domain, error.what())});
  }
  if (exchange_)
    grant_new_credits();
}

void Routing::begin_observation(const FaceExchange& exchange, double start_time, double end_time) {
  if (options_.observer == nullptr)
    return;
  ExchangeStart start{.session = options_.session,
                      .mode = options_.mode,
                      .window_steps = options_.window_steps,
                      .sources = roster_.sources(),
                      .needed_steps = {},
                      .domain = roster_.domain().expected.name,
                      .domain_number = roster_.domain().number,
                      .faces = exchange.faces(),
                      .start_time = start_time,
                      .end_time = end_time};
  for (const auto& inlet : exchange.inlets())
    of(*roster_.with_number(inlet.address.sender)).at(inlet.address.field).needed =
        inlet.history.needed_until(end_time);
  for (const auto& source : roster_.all())
    if (!source.is_domain()) {
      auto& needed = start.needed_steps.emplace_back();
      std::ranges::transform(of(source), std::back_inserter(needed), &Outlet::needed);
    }
  try {
    options_.observer->begin(start);
  } catch (const std::exception& error) {
    throw Fault({"", error.what(), options_.resume.has_value()});
  }
}

void Routing::observe(std::span<const std::byte> bytes) {
  if (options_.observer == nullptr)
    return;
  try {
    options_.observer->frame(bytes);
  } catch (const std::exception& error) {
    throw Fault({"", error.what()});
  }
}

void Routing::take_credit(const json& body) {
  const auto number = whole_32_at(body, "source");
  const auto* source = roster_.with_number(number);
  if (source == nullptr)
    throw Error(fmt::format("CREDIT for participant {}, which does not exist", number));
  grant(*source, whole_32_at(body, "field"), whole_at(body, "steps"));
}

void Routing::grant_new_credits() {
  for (const auto& credit : exchange_->new_credits())
    grant(*roster_.with_number(credit.address.sender), credit.address.field, credit.steps);
}

void Routing::grant(const Participant& source, std::uint32_t field, std::uint64_t steps) {
  if (field >= source.fields.size())
    throw Error(
        fmt::format("CREDIT for field {} of '{}', which does not exist", field, source.expected.name));
  const bool idle = !owes_a_frame(source);
  auto& credit = of(source)[field].credit;
  credit = std::max(credit, std::min(steps, source.fields[field].step_count));
  if (idle && owes_a_frame(source))
    watch_.asked(source);
  post_.send(source.routing_id, {"CREDIT", {{"field", field}, {"steps", credit}}});
}

bool Routing::owes_a_frame(const Participant& source) {
  const auto& outlets = of(source);
  for (std::size_t f = 0; f < outlets.size(); ++f) {
    const auto& [next_step, credit, needed] = outlets[f];
    const auto& field = source.fields[f];
    if (credit - next_step >= field.steps_per_frame || (next_step < credit && credit == field.step_count))
      return true;
  }
  return false;
}

void Routing::take_wait(const json& body) {
  if (options_.mode != Mode::window)
    return;
  std::optional<FaceExchange::Missing> awaited;
  if (body.contains("waiting")) {
    const json& waiting = value_at(body, "waiting");
    awaited = {text_at(waiting, "source"), text_at(waiting, "field"), whole_at(waiting, "step")};
  }
  watch_.domain_waits_for(awaited);
}

void Routing::take_source_frame(const Participant& source, zmq::message_t& raw) {
  const std::span<const std::byte> bytes(static_cast<const std::byte*>(raw.data()), raw.size());
  if (bytes.size() < frame_header_size)
    throw Error(fmt::format("a message of {} bytes is neither JSON nor a frame", bytes.size()));
  const auto field = claimed_origin(bytes).field;
  if (field >= source.fields.size())
    throw Error(fmt::format("a frame of field {}, but it serves {} fields", field, source.fields.size()));
  auto& outlet = of(source)[field];
  const auto& description = source.fields[field];
  const auto decoded =
      decode(bytes, {.session = options_.session,
                     .sender = source.number,
                     .field = field,
                     .step = outlet.next_step,
                     .count = static_cast<std::uint32_t>(description.values_per_step()),
                     .most_steps = static_cast<std::uint32_t>(outlet.credit - outlet.next_step)});
  const auto* error = std::get_if<FrameError>(&decoded);
  if (error != nullptr && error->code != FrameError::Code::not_finite)
    throw Error(fmt::format("field '{}', step {}: {}", description.name, outlet.next_step, error->text));
  if (const auto wrong = implausible(description, outlet.next_step, bytes.subspan(frame_header_size)))
    throw Error(fmt::format("field '{}', {}", description.name, *wrong));
  const auto& frame = std::get<Frame>(decoded);
  watch_.advanced(source);
  outlet.next_step += frame.header.steps;
  keeper_.remember(source, field, frame);
  watch_.arrived(source, description.name, outlet.next_step);
  observe(bytes);
  if (roster_.domain().left) {
    dismiss_sources();
    return;
  }
  if (!exchange_) {
    // Byte for byte: the source's own checksum is checked again where the numbers are used.
    post_.forward(roster_.domain().routing_id, raw);
    return;
  }
  exchange_->find({source.number, field})->history.append(frame.body);
  grant_new_credits();
  answer_pending_step();
}

void Routing::take_velocities(const Participant& domain, std::span<const std::byte> bytes) {
  if (!ready_)
    throw Error("velocities before READY");
  const std::size_t count = layout::velocities(face_count_);
  const auto decoded = decode(bytes, {.session = options_.session,
                                      .sender = domain.number,
                                      .step = next_domain_step_,
                                      .count = static_cast<std::uint32_t>(count),
                                      .most_steps = options_.mode == Mode::lockstep ? 1U : ~0U});
  if (const auto* error = std::get_if<FrameError>(&decoded))
    throw Error(fmt::format("velocities of step {}: {}", next_domain_step_, error->text));
  const auto& frame = std::get<Frame>(decoded);
  watch_.advanced(domain);
  next_domain_step_ += frame.header.steps;
  observe(bytes);
  watch_.domain_waits_for(std::nullopt);
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

void Routing::answer_pending_step() {
  if (!pending_)
    return;
  watch_.domain_waits_for(exchange_->missing(pending_->time));
  if (watch_.domain_waits())
    return;
  std::vector<eq6::FreeField> free_field(face_count_);
  exchange_->read(pending_->time, free_field);
  zmq::message_t raw(frame_header_size + layout::per_face * face_count_ * sizeof(double));
  const std::span bytes(static_cast<std::byte*>(raw.data()), raw.size());
  for (std::size_t i = 0; i < face_count_; ++i) {
    const auto& [v, s] = free_field[i];
    const auto [tx, ty] = exchange_->faces()[i].traction(pending_->v_domain[i], free_field[i]);
    const std::array<double, layout::per_face> values{tx, ty, v.x, v.y, s.xx, s.yy, s.xy};
    std::memcpy(bytes.data() + frame_header_size + i * sizeof values, values.data(), sizeof values);
  }
  seal({.session = options_.session,
        .step = pending_->step,
        .steps = 1,
        .count = static_cast<std::uint32_t>(layout::per_face * face_count_)},
       bytes);
  observe(bytes);
  post_.forward(roster_.domain().routing_id, raw);
  pending_.reset();
  grant_new_credits();
}

/// The domain stops a little before the end. A source may then lack the last steps up to it, and a recording
/// would hold less than a run asks for when it is served again.
void Routing::end() {
  for (const auto& source : roster_.all())
    for (std::uint32_t f = 0; f < source.fields.size(); ++f) {
      const auto [next_step, credit, needed] = of(source)[f];
      const std::uint64_t frame = source.fields[f].steps_per_frame;
      if (needed > credit)
        grant(source, f, credit + (needed - credit + frame - 1) / frame * frame);
    }
  dismiss_sources();
}

void Routing::dismiss_sources() {
  if (dismissed_)
    return;
  for (const auto& source : roster_.all())
    for (const auto& outlet : of(source))
      if (outlet.next_step < outlet.needed)
        return;
  dismissed_ = true;
  for (const auto& participant : roster_.all())
    if (!participant.left)
      post_.send(participant.routing_id, {"BYE"});
}

} // namespace tremolo::coupler
