#include "coupler/hub/admission/admission.hpp"

#include "coupler/hub/admission/case_difference.hpp"
#include "coupler/hub/progress.hpp"
#include "coupler/wire/frame.hpp"
#include "coupler/wire/handshake/json_keys.hpp"
#include "coupler/wire/sockets.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace tremolo::coupler {

using nlohmann::json;

void Admission::require_own_key(Letter& letter, const std::string& claimed) {
  if (const auto owner = letter.key_owner(); !owner.empty() && owner != claimed)
    throw Refusal(fmt::format("'{}' came with the key of '{}'", claimed, owner));
}

Participant& Admission::take_hello(Letter& letter, const json& hello) {
  const auto claimed = text_at(hello, "name");
  require_own_key(letter, claimed);
  // The session is a secret: it is not sent to those who do not know it.
  if (const auto session = text_at(hello, "session"); session != session_text(options_.session))
    throw Refusal(fmt::format("'{}' belongs to session {}, which is not that of this run", claimed, session));
  auto* participant = roster_.with_name(claimed);
  if (participant == nullptr)
    throw Refusal(fmt::format("this run has no participant '{}'", claimed));
  if (!participant->routing_id.empty())
    throw Refusal(fmt::format("'{}' is already taking part in this run; a second one was refused", claimed));
  auto reason = objection(*participant, hello);
  std::vector<FieldDescription> fields;
  if (!reason && !participant->is_domain())
    try {
      fields = fields_of(hello);
    } catch (const Error& error) {
      reason = fmt::format("'{}' (build {}) cannot be a source of this run: {}", claimed,
                           text_at(hello, "build"), error.what());
    }
  if (reason) {
    post_.send(letter.routing_id, {"REFUSE", {{"reason", *reason}}});
    throw Fault({claimed, *reason});
  }
  participant->routing_id = letter.routing_id;
  participant->fields = std::move(fields);
  return *participant;
}

std::optional<std::string> Admission::objection(const Participant& participant, const json& hello) const {
  const auto build = text_at(hello, "build");
  for (const auto& [key, expected] :
       {std::pair<const char*, std::string>{"protocol", std::to_string(protocol_version)},
        {"role", std::string(name(participant.expected.role))},
        {"units", "SI"},
        {"case", text_crc(options_.case_text)}}) {
    const json& said = value_at(hello, key);
    const std::string found = said.is_string() ? said.get<std::string>() : shown(said);
    if (found == expected)
      continue;
    auto difference = fmt::format("'{}' (build {}) says {} = {}, the hub (build {}) has {}",
                                  participant.expected.name, build, key, found, TREMOLO_VERSION, expected);
    if (key == std::string_view("case") && hello.contains("case_text"))
      difference += "; " + case_difference(text_at(hello, "case_text"), options_.case_text);
    return difference;
  }
  return std::nullopt;
}

std::vector<FieldDescription> Admission::fields_of(const json& hello) const {
  std::vector<FieldDescription> fields;
  for (const auto& said : list_at(hello, "fields")) {
    auto field = field_from(said);
    if (std::ranges::find(fields, field.name, &FieldDescription::name) != fields.end())
      throw Error(fmt::format("it serves two fields called '{}'", field.name));
    require_fits(frame_header_size + sizeof(double) * field.values_per_step());
    field.steps_per_frame = steps_per_frame(field, options_.window_steps);
    fields.push_back(std::move(field));
  }
  return fields;
}

void Admission::take_join(Letter& letter, const json& join) {
  const auto wanted = text_at(join, "name");
  require_own_key(letter, wanted);
  auto* participant = roster_.with_name(wanted);
  if (participant == nullptr)
    throw Refusal(fmt::format("this run has no participant '{}'", wanted));
  if (!participant->expected.elsewhere)
    throw Refusal(
        fmt::format("'{}' is started by the run itself: [hosts] does not place it elsewhere", wanted));
  if (!participant->routing_id.empty() ||
      (!participant->usher.empty() && post_.send(participant->usher, {"BEAT"})))
    throw Refusal(fmt::format("'{}' is already taking part in this run; a second one was refused", wanted));
  if (const auto version = whole_at(join, "protocol"); version != protocol_version)
    throw Refusal(fmt::format("'{}' (build {}) says protocol = {}, the hub (build {}) has {}", wanted,
                              text_at(join, "build"), version, TREMOLO_VERSION, protocol_version));
  if (const auto run = text_or(join, "run", options_.run_number); run != options_.run_number)
    throw Refusal(fmt::format("'{}' is meant for run {}, this is run {}", wanted, run, options_.run_number));
  if (const auto text = text_or(join, "case_text", options_.case_text); text != options_.case_text)
    throw Refusal(
        fmt::format("'{}' has another case: {}", wanted, case_difference(text, options_.case_text)));
  participant->usher = letter.routing_id;
  post_.send(letter.routing_id, {"INVITE", to_json(Invitation{options_.session, options_.case_text,
                                                              options_.files, options_.deadlines})});
}

} // namespace tremolo::coupler
