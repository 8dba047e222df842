// tremolo-recording: serves a recorded free field, bit for bit as it was recorded: one that was recorded
// alone, or what served a side in the recorded exchange of a run.

#include "coupler/participant.hpp"
#include "coupler/process/recorded_case.hpp"
#include "results/exchange_file.hpp"
#include "results/free_field_recording.hpp"
#include "scene/plan/service.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tremolo::coupler {

namespace {

struct Range {
  double first = 0.0;
  double last = 0.0;
};

/// @param hair what rounding may take away at either end
bool covers(const Range& have, const Range& asked, double hair) {
  return have.first <= asked.first + hair && have.last >= asked.last - hair;
}

coupler::FieldDescription description_of(const results::RecordedField& field) {
  return {.name = field.name,
          .y = field.levels,
          .x_reference = field.x_reference,
          .slowness_x = field.slowness_x,
          .start_time = field.start_time,
          .time_step = field.time_step,
          .step_count = field.step_count};
}

/// Indices of the fields whose sum faces take as `name`.
std::vector<std::size_t> find(const std::vector<results::RecordedField>& fields, std::string_view name,
                              const std::string& file) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (coupler::adds_to(description_of(fields[i]), name))
      found.push_back(i);
  if (!found.empty())
    return found;
  std::string held;
  for (const auto& field : fields)
    held += fmt::format("{}'{}'", held.empty() ? "" : ", ", field.name);
  throw std::invalid_argument(
      fmt::format("{}: the case asks for the field '{}', recorded are: {}", file, name, held));
}

/// Largest lead, relative to the box's left edge, with which a face reads the line, s; a face lies less than
/// a cell beside the edge. The hub knows the faces themselves and makes the final check.
double delay_of_first_face(const scene::Case& scene, const scene::SourceProcess& source, double slowness_x) {
  const bool right_only = std::ranges::all_of(
      source.serves, [](const scene::Served& served) { return served.side == scene::Side::right; });
  return slowness_x * ((right_only ? scene.mesh.box.width() : 0.0) + scene.mesh.size);
}

/// Refuses a recording that ends before the case does, in depth or in time.
void require_cover(const coupler::FieldDescription& field, const scene::Case& scene,
                   const scene::SourceProcess& source, const std::string& file) {
  const scene::Service asked = scene::service(scene, source, field.slowness_x);
  const auto line = std::ranges::find_if(
      asked.lines, [&](const scene::ServedLine& l) { return coupler::adds_to(field, scene::name(l.field)); });
  const Range levels{line->levels.front(), line->levels.back()};
  // The case asks on its own line; the recording's may stand elsewhere.
  const double shift = field.slowness_x * (asked.x_line - field.x_reference);
  const Range times{asked.start_time - shift,
                    asked.end_time - shift - delay_of_first_face(scene, source, field.slowness_x)};
  const Range recorded_levels{field.y.front(), field.y.back()};
  const Range recorded_times{field.start_time, field.end_time()};
  if (covers(recorded_levels, levels, 1e-6) && covers(recorded_times, times, 1e-6 * field.time_step))
    return;
  const auto text = [](const Range& y, const Range& t) {
    return fmt::format("from y = {:.9g} to {:.9g} m and from {:.9g} to {:.9g} s", y.first, y.last, t.first,
                       t.last);
  };
  throw std::invalid_argument(fmt::format("{}: field '{}' is recorded {}, but the case asks for it {}", file,
                                          field.name, text(recorded_levels, recorded_times),
                                          text(levels, times)));
}

scene::Side side_from(const std::string& text) {
  for (const scene::Side side : {scene::Side::left, scene::Side::right, scene::Side::base})
    if (scene::name(side) == text)
      return side;
  throw std::invalid_argument(fmt::format("--side is '{}', must be left, right or base", text));
}

/// The recorded exchange of another free field is refused, with what is different.
void require_same_free_field(const results::ExchangeReader& exchange, const scene::Case& scene,
                             const scene::SourceProcess& source, const std::string& side,
                             const std::string& file) {
  constexpr std::size_t most_shown = 5;
  std::vector<std::string> differences;
  for (const scene::Served& served : source.serves)
    for (auto& difference : coupler::free_field_differences(exchange.description().case_values,
                                                            side_from(side), scene, served.side))
      if (std::ranges::find(differences, difference) == differences.end())
        differences.push_back(std::move(difference));
  if (differences.empty())
    return;
  std::string text = fmt::format("{}: the free field of its case is not that of this case", file);
  for (const auto& difference : std::span(differences).first(std::min(differences.size(), most_shown)))
    text += "\n    " + difference;
  if (differences.size() > most_shown)
    text += fmt::format("\n    and {} more", differences.size() - most_shown);
  throw std::invalid_argument(text);
}

/// Opens what served a side in a recorded exchange, or a free field that was recorded alone.
results::FreeFieldRecording opened(const std::string& file, const std::string& side, const scene::Case& scene,
                                   const scene::SourceProcess& source) {
  if (side.empty())
    return results::FreeFieldRecording(file);
  const results::ExchangeReader exchange(file);
  require_same_free_field(exchange, scene, source, side, file);
  if (!exchange.complete())
    fmt::print("warning: {} is not complete ({})\n", file, exchange.status());
  return results::FreeFieldRecording(file, exchange.source_of(side).name);
}

/// Why a recording ends before the case does, where it is known.
std::string reason_for_end(const std::string& file, const std::string& side) {
  if (side.empty())
    return {};
  const results::ExchangeReader exchange(file);
  return exchange.complete() ? "" : fmt::format("; the recording is not complete: {}", exchange.status());
}

void run(const coupler::ParticipantOptions& options, const std::string& file, const std::string& side) {
  if (file.empty())
    throw std::invalid_argument("--file is missing: the recording to serve");
  const scene::Case scene = scene::load(options.case_file);
  const scene::Plan plan = scene::plan(scene);
  const scene::SourceProcess& source = scene::source_named(plan, options.name);
  const results::FreeFieldRecording recording = opened(file, side, scene, source);

  std::vector<std::size_t> recorded;
  std::vector<coupler::FieldDescription> fields;
  for (const scene::ServedLine& line : scene::service(scene, source, 0.0).lines)
    for (const std::size_t number : find(recording.fields(), scene::name(line.field), file)) {
      recorded.push_back(number);
      fields.push_back(description_of(recording.fields()[number]));
      try {
        coupler::validate(fields.back());
        require_cover(fields.back(), scene, source, file);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(error.what() + reason_for_end(file, side));
      }
    }

  coupler::SourceClient client(options, fields);
  client.serve([&](std::size_t f, std::uint64_t step, std::span<double> values) {
    recording.read(recorded[f], step, values);
  });
}

} // namespace
} // namespace tremolo::coupler

int main(int argc, char** argv) {
  std::string file;
  std::string side;
  return tremolo::coupler::participant_main(
      "tremolo-recording", "A recorded free field, as a source.", argc, argv,
      [&](const tremolo::coupler::ParticipantOptions& options) {
        tremolo::coupler::run(options, file, side);
      },
      {{"--file", "recording (HDF5) to serve; required", file},
       {"--side", "left, right or base: what served this side in a recorded exchange", side}});
}
