#include "coupler/hub/watch.hpp"

#include "coupler/wire/handshake/json_keys.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace tremolo::coupler {

using nlohmann::json;

namespace {

/// A wait that is worth a line, though no failure yet, s.
constexpr double long_wait_s = 5.0;

std::string deadline_text(double patience, double deadline) {
  return patience > deadline
             ? fmt::format("deadline {:.1f} s, 20 times the median of its last steps", patience)
             : fmt::format("deadline {} s", deadline);
}

} // namespace

Watch::Watch(const Deadlines& deadlines, Roster& roster, Notes& notes)
    : deadlines_(deadlines), roster_(roster), notes_(notes), start_(Clock::now()),
      signs_(roster.all().size()) {}

void Watch::begin() {
  timeline_ = Timeline();
  for (auto& signs : signs_)
    signs.pace.asked();
}

void Watch::advanced(const Participant& participant) {
  heard(participant);
  of(participant).pace.advanced();
}

void Watch::source_beats(const Participant& source, const json& body) {
  auto& signs = of(source);
  if (const double done = body.contains("done") ? number_at(body, "done") : 0.0; done > signs.work_done) {
    signs.work_done = done;
    signs.pace.advanced();
  }
}

void Watch::domain_beats(const Participant& domain, const json& body) {
  Progress now{text_at(body, "stage"), whole_at(body, "step"), number_at(body, "time"),
               number_at(body, "end_time")};
  if (body.contains("residual"))
    now.residual = number_at(body, "residual");
  const Progress before = std::exchange(progress_, std::move(now));
  if (wait_ || progress_ != before)
    of(domain).pace.advanced();
}

void Watch::domain_waits_for(const std::optional<FaceExchange::Missing>& awaited) {
  timeline_.turn_to(awaited ? waiting_for(awaited->source) : std::string(computing));
  if (!awaited)
    wait_.reset();
  else if (!wait_ || wait_->awaited != *awaited)
    wait_ = Wait{*awaited, Clock::now()};
}

void Watch::arrived(const Participant& source, const std::string& field, std::uint64_t next_step) {
  if (wait_ && wait_->awaited.source == source.expected.name && wait_->awaited.field == field &&
      wait_->awaited.step < next_step)
    wait_.reset();
}

std::optional<Failure> Watch::absent() const {
  const double waited = seconds_since(start_);
  if (waited < deadlines_.connect)
    return std::nullopt;
  std::string missing;
  std::string first;
  for (const auto& p : roster_.all())
    if (p.routing_id.empty()) {
      missing +=
          fmt::format("{}{} '{}'", missing.empty() ? "" : ", ", name(p.expected.role), p.expected.name);
      first = first.empty() ? p.expected.name : first;
    }
  return Failure{
      first, fmt::format("no HELLO from {} within {} s; the hub has waited {:.1f} s without any sign of life",
                         missing, deadlines_.connect, waited)};
}

std::optional<Failure> Watch::overdue(const std::string& owed) {
  const auto& domain = roster_.domain();
  const auto& signs = of(domain);
  const double patience = signs.pace.patience(deadlines_.step);
  if (!domain.left && signs.pace.silence() >= patience)
    return Failure{
        domain.expected.name,
        fmt::format("the hub waits for {} of domain '{}', which has not got on since {:.1f} s ({}): stage "
                    "'{}', step {}, {} s; its last sign of life {:.1f} s ago",
                    owed, domain.expected.name, signs.pace.silence(),
                    deadline_text(patience, deadlines_.step), progress_.stage, progress_.step, progress_.time,
                    seconds_since(signs.last_heard))};
  return overdue_source();
}

std::optional<Failure> Watch::overdue_source() {
  const auto* source = wait_ ? roster_.with_name(wait_->awaited.source) : nullptr;
  if (source == nullptr)
    return std::nullopt;
  const double waited = seconds_since(wait_->since);
  const double patience = of(*source).pace.patience(deadlines_.step);
  if (std::min(waited, of(*source).pace.silence()) > patience)
    return Failure{source->expected.name, wait_text(*source, waited, patience)};
  if (!wait_->noted && waited > std::min(long_wait_s, 0.5 * patience)) {
    wait_->noted = true;
    notes_.show(wait_text(*source, waited, patience));
  }
  return std::nullopt;
}

std::string Watch::wait_text(const Participant& source, double waited, double patience) {
  return fmt::format("domain '{}' waits for source '{}', field '{}', step {}, since {:.1f} s ({}); last sign "
                     "of life of '{}' {:.1f} s ago",
                     roster_.domain().expected.name, wait_->awaited.source, wait_->awaited.field,
                     wait_->awaited.step, waited, deadline_text(patience, deadlines_.step),
                     source.expected.name, seconds_since(of(source).last_heard));
}

std::optional<Failure> Watch::lost(const Participant& participant, bool connected) {
  constexpr double patience_s = 1.0; // its last words, or those of who has started it, say more
  auto& line_lost = of(participant).line_lost;
  if (connected || !participant.expected.elsewhere)
    line_lost.reset();
  else if (!line_lost)
    line_lost = Clock::now();
  else if (seconds_since(*line_lost) > patience_s)
    return Failure{
        participant.expected.name,
        fmt::format("the connection to '{}' on another machine is gone: its process has ended, or something "
                    "between the machines has closed it",
                    participant.expected.name)};
  return std::nullopt;
}

} // namespace tremolo::coupler
