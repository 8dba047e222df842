#include "coupler/conformance/conformance_session.hpp"

#include "base/text/text_file.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/frame.hpp"
#include "coupler/wire/handshake/json_keys.hpp"
#include "coupler/wire/mode.hpp"
#include "coupler/wire/plausible.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <set>
#include <string_view>
#include <utility>

namespace tremolo::coupler::conformance {

using nlohmann::json;

namespace {

constexpr std::array<std::string_view, row_count> row_names{
    "starts and says HELLO", "handshake",       "fields",   "points",      "times",          "steps",
    "finite values",         "rates",           "momentum", "quiet start", "ends after BYE", "repeats",
    "ends on ABORT",         "ends without hub"};

template <typename Read>
auto guarded(Row row, const Read& read) {
  try {
    return read();
  } catch (const std::exception& error) {
    throw Objection{row, error.what()};
  }
}

} // namespace

Report::Report() {
  for (const auto row_name : row_names)
    checks_.push_back({std::string(row_name), Verdict::skipped, "not reached"});
}

void Report::set(Row row, Verdict verdict, std::string finding) {
  checks_[row].verdict = verdict;
  checks_[row].finding = std::move(finding);
}

void Session::shake_hands() {
  const auto start = Clock::now();
  const Message message = guarded(hello, [&] { return probe_.hello(); });
  if (message.type != "HELLO")
    throw Objection{hello, fmt::format("its first message is {}", message.type)};
  report_.pass(hello, fmt::format("after {:.2f} s", seconds_since(start)));
  check_handshake(message.body);
  check_fields(message.body);
  check_points();
  check_times();
  probe_.send({"WELCOME",
               {{"number", SourceProbe::number},
                {"mode", name(Mode::window)},
                {"sources", json::array({to_json(source_)})}}});
}

void Session::exchange(double end_time) {
  std::vector<eq6::FreeField> free_field(demand_.faces.size());
  const double step = std::ranges::min(source_.fields, {}, &FieldDescription::time_step).time_step;
  const auto count = static_cast<std::uint64_t>(std::ceil((end_time - demand_.start_time) / step));
  for (std::uint64_t n = 0; n <= count; ++n) {
    const double now = std::min(demand_.start_time + static_cast<double>(n) * step, end_time);
    grant_credits();
    while (const auto missing = exchange_->missing(now)) {
      wait_for(*missing);
      grant_credits();
    }
    exchange_->read(now, free_field);
  }
  std::string counts;
  for (const auto& s : series_)
    if (!s.values.empty())
      counts += fmt::format("{}{} of '{}'", counts.empty() ? "" : ", ", s.steps(), s.field.name);
  report_.pass(steps, counts + ", in order, once, within the credit");
  report_.pass(finite, "all");
}

void Session::check_handshake(const json& said) {
  std::string differences;
  for (const auto& [key, expected] : {std::pair<const char*, json>{"protocol", protocol_version},
                                      {"session", session_text(probe_.session())},
                                      {"name", options_.name},
                                      {"role", "source"},
                                      {"units", "SI"},
                                      {"case", text_crc(read_text_file(options_.case_file))}})
    if (const json found = said.value(key, json("nothing")); found != expected)
      differences += fmt::format("{}{} is {}, expected {}", differences.empty() ? "" : "; ", key,
                                 found.dump(), expected.dump());
  if (!said.value("build", json()).is_string())
    differences += fmt::format("{}build is missing", differences.empty() ? "" : "; ");
  if (!differences.empty())
    throw Objection{handshake, differences};
  report_.pass(handshake,
               fmt::format("protocol {}, role source, units SI, case {}, build {}", protocol_version,
                           said["case"].get<std::string>(), said["build"].get<std::string>()));
}

void Session::check_fields(const json& said) {
  source_ = {options_.name, SourceProbe::number, {}};
  guarded(fields, [&] {
    for (const auto& field : list_at(said, "fields"))
      source_.fields.push_back(field_from(field));
  });
  for (auto& field : source_.fields)
    field.steps_per_frame = steps_per_frame(field, default_window_steps);
  std::string names;
  for (const auto& field : source_.fields)
    names += fmt::format("{}'{}' at {} levels", names.empty() ? "" : ", ", field.name, field.y.size());
  std::set<std::string> asked;
  for (const auto& face : demand_.faces)
    asked.insert(face.field);
  for (const auto& wanted : asked)
    if (std::ranges::none_of(source_.fields, [&](const auto& field) { return adds_to(field, wanted); }))
      throw Objection{fields, fmt::format("the case asks for '{}', served are: {}", wanted, names)};
  report_.pass(fields, names);
  for (const auto& field : source_.fields)
    series_.push_back({field, {}});
}

void Session::check_points() {
  guarded(points, [&] {
    for (const auto& face : demand_.faces)
      for (const auto& field : source_.fields)
        if (adds_to(field, face.field))
          map_face(field, face.position);
  });
  std::string ranges;
  for (const auto& field : source_.fields)
    ranges += fmt::format("{}'{}' y = {:.6g} to {:.6g} m", ranges.empty() ? "" : ", ", field.name,
                          field.y.front(), field.y.back());
  report_.pass(points, ranges);
}

void Session::check_times() {
  guarded(times, [&] {
    exchange_.emplace(std::vector{source_}, demand_.faces, demand_.start_time, demand_.end_time);
  });
  const auto& field = source_.fields.front();
  report_.pass(times,
               fmt::format("'{}' from {:.6g} to {:.6g} s, step {:.4g} s, slowness {:.4g} s/m", field.name,
                           field.start_time, field.end_time(), field.time_step, field.slowness_x));
}

void Session::grant_credits() {
  for (const auto& credit : exchange_->new_credits())
    probe_.send({"CREDIT", {{"field", credit.address.field}, {"steps", credit.steps}}});
}

void Session::wait_for(const FaceExchange::Missing& missing) {
  const auto incoming = guarded(steps, [&] { return probe_.receive(0.05); });
  if (!incoming) {
    if (seconds_since(last_heard_) > options_.deadlines.step)
      throw Objection{steps, fmt::format("no step {} of '{}' and no sign of life for {} s", missing.step,
                                         missing.field, options_.deadlines.step)};
    return;
  }
  last_heard_ = Clock::now();
  if (!incoming->message)
    take_frame(incoming->frame());
  else if (incoming->message->type != "BEAT")
    throw Objection{steps, fmt::format("the program said {} when step {} of '{}' was awaited: {}",
                                       incoming->message->type, missing.step, missing.field,
                                       incoming->message->body.value("reason", "no reason given"))};
}

void Session::take_frame(std::span<const std::byte> bytes) {
  const auto [sender, field] = claimed_origin(bytes);
  auto* inlet = exchange_->find({sender, field});
  if (inlet == nullptr)
    throw Objection{
        steps, fmt::format("a frame of field {} of participant {}, which was not asked for", field, sender)};
  auto& history = inlet->history;
  const auto decoded = decode(
      bytes, {.session = probe_.session(),
              .sender = sender,
              .field = field,
              .step = history.next_step(),
              .count = static_cast<std::uint32_t>(history.field().values_per_step()),
              .most_steps = static_cast<std::uint32_t>(inlet->announced_credit - history.next_step())});
  const auto* error = std::get_if<FrameError>(&decoded);
  if (error != nullptr && error->code != FrameError::Code::not_finite)
    throw Objection{steps, fmt::format("frame of '{}' at step {}: {}", history.field().name,
                                       history.next_step(), error->text)};
  if (const auto wrong = implausible(history.field(), history.next_step(), bytes.subspan(frame_header_size)))
    throw Objection{finite, fmt::format("frame of '{}', {}", history.field().name, *wrong)};
  const Frame& frame = std::get<Frame>(decoded);
  history.append(frame.body);
  const auto values = frame.values();
  series_[field].values.insert(series_[field].values.end(), values.begin(), values.end());
}

} // namespace tremolo::coupler::conformance
