// Who has waited too long for whom. Only what gets on prolongs a wait: a frame, a later step, a beat that
// reports more work done. A solver that loops and beats all the same is stuck.

#include "coupler/hub/hub.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace tremolo::coupler {

namespace {

/// A wait that is worth a line, though no failure yet, s.
constexpr double long_wait_s = 5.0;

std::string deadline_text(double patience, double deadline) {
  return patience > deadline
             ? fmt::format("deadline {:.1f} s, 20 times the median of its last steps", patience)
             : fmt::format("deadline {} s", deadline);
}

} // namespace

void Hub::check_connect_deadline() {
  const double waited = seconds_since(start_);
  if (waited < options_.deadlines.connect)
    return;
  std::string missing;
  std::string first;
  for (const auto& p : participants_)
    if (p.routing_id.empty()) {
      missing +=
          fmt::format("{}{} '{}'", missing.empty() ? "" : ", ", name(p.expected.role), p.expected.name);
      first = first.empty() ? p.expected.name : first;
    }
  fail(first,
       fmt::format("no HELLO from {} within {} s; the hub has waited {:.1f} s without any sign of life",
                   missing, options_.deadlines.connect, waited));
}

void Hub::check_domain_deadline() {
  const auto& p = domain();
  const double patience = p.pace.patience(options_.deadlines.step);
  if (p.left || p.pace.silence() < patience)
    return;
  fail(p.expected.name,
       fmt::format("the hub waits for {} of domain '{}', which has not got on since {:.1f} s ({}): stage "
                   "'{}', step {}, {} s; its last sign of life {:.1f} s ago",
                   ready_ ? fmt::format("the velocities of step {}", next_domain_step_) : "READY",
                   p.expected.name, p.pace.silence(), deadline_text(patience, options_.deadlines.step),
                   progress_.stage, progress_.step, progress_.time, seconds_since(p.last_heard)));
}

void Hub::check_source_deadline() {
  if (!wait_)
    return;
  const auto* source = find_name(wait_->awaited.source);
  if (source == nullptr)
    return;
  const double waited = seconds_since(wait_->since);
  const double patience = source->pace.patience(options_.deadlines.step);
  const auto text = [&] {
    return fmt::format(
        "domain '{}' waits for source '{}', field '{}', step {}, since {:.1f} s ({}); last sign "
        "of life of '{}' {:.1f} s ago",
        domain().expected.name, wait_->awaited.source, wait_->awaited.field, wait_->awaited.step, waited,
        deadline_text(patience, options_.deadlines.step), source->expected.name,
        seconds_since(source->last_heard));
  };
  if (std::min(waited, source->pace.silence()) > patience)
    fail(source->expected.name, text());
  else if (!wait_->noted && waited > std::min(long_wait_s, 0.5 * patience)) {
    wait_->noted = true;
    options_.note(text());
  }
}

} // namespace tremolo::coupler
