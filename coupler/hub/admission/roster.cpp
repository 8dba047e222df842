#include "coupler/hub/admission/roster.hpp"

#include "coupler/wire/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace tremolo::coupler {

namespace {

template <typename Is>
Participant* found(std::vector<Participant>& participants, const Is& is) {
  const auto p = std::ranges::find_if(participants, is);
  return p == participants.end() ? nullptr : &*p;
}

} // namespace

std::string_view name(Role role) {
  return role == Role::source ? "source" : "domain";
}

Roster::Roster(const std::vector<ExpectedParticipant>& expected) {
  for (const auto& one : expected) {
    if (with_name(one.name) != nullptr)
      throw Error(fmt::format("two participants are called '{}'", one.name));
    participants_.push_back(
        {.expected = one, .number = static_cast<std::uint32_t>(participants_.size() + 1)});
  }
  const auto domains = std::ranges::count_if(participants_, &Participant::is_domain);
  if (domains != 1)
    throw Error(fmt::format("a run has one domain, {} were given", domains));
}

Participant& Roster::domain() {
  return *std::ranges::find_if(participants_, &Participant::is_domain);
}

Participant* Roster::with_name(const std::string& name) {
  return found(participants_, [&](const auto& p) { return p.expected.name == name; });
}

Participant* Roster::with_number(std::uint32_t number) {
  return found(participants_, [&](const auto& p) { return p.number == number; });
}

Participant* Roster::at_connection(const std::string& routing_id) {
  return found(participants_, [&](const auto& p) { return p.routing_id == routing_id; });
}

Participant* Roster::ushered_by(const std::string& routing_id) {
  return found(participants_, [&](const auto& p) { return p.usher == routing_id; });
}

bool Roster::is_complete() const {
  return std::ranges::none_of(participants_, [](const auto& p) { return p.routing_id.empty(); });
}

std::vector<SourceDescription> Roster::sources() const {
  std::vector<SourceDescription> list;
  for (const auto& p : participants_)
    if (!p.is_domain())
      list.push_back({p.expected.name, p.number, p.fields});
  return list;
}

} // namespace tremolo::coupler
