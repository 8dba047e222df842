// tremolo-recording: serves a recorded free field, bit for bit as it was recorded.

#include "coupler/source_client.hpp"
#include "results/free_field_recording.hpp"
#include "scene/service.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace tremolo;

struct Range {
  double first = 0.0;
  double last = 0.0;
};

/// @param hair what rounding may take away at either end
bool covers(const Range& have, const Range& asked, double hair) {
  return have.first <= asked.first + hair && have.last >= asked.last - hair;
}

std::size_t find(const std::vector<results::RecordedField>& fields, std::string_view name,
                 const std::string& file) {
  const auto found = std::ranges::find(fields, name, &results::RecordedField::name);
  if (found != fields.end())
    return static_cast<std::size_t>(found - fields.begin());
  std::string held;
  for (const auto& field : fields)
    held += fmt::format("{}'{}'", held.empty() ? "" : ", ", field.name);
  throw std::invalid_argument(
      fmt::format("{}: the case asks for the field '{}', recorded are: {}", file, name, held));
}

/// Refuses a recording that ends before the case does, in depth or in time.
void require_cover(const coupler::FieldDescription& field, const scene::Case& scene,
                   const scene::SourceProcess& source, const std::string& file) {
  const scene::Service asked = scene::service(scene, source, field.slowness_x);
  const auto line = std::ranges::find_if(
      asked.lines, [&](const scene::ServedLine& l) { return scene::name(l.field) == field.name; });
  const Range levels{line->levels.front(), line->levels.back()};
  // The case asks on its own line; the recording's may stand elsewhere.
  const double shift = field.slowness_x * (asked.x_line - field.x_reference);
  const Range times{asked.start_time - shift, asked.end_time - shift};
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

void run(const coupler::ParticipantOptions& options, const std::string& file) {
  if (file.empty())
    throw std::invalid_argument("--file is missing: the recording to serve");
  const results::FreeFieldRecording recording(file);
  const scene::Case scene = scene::load(options.case_file);
  const scene::Plan plan = scene::plan(scene);
  const scene::SourceProcess& source = scene::source_named(plan, options.name);

  std::vector<std::size_t> recorded;
  std::vector<coupler::FieldDescription> fields;
  for (const scene::ServedLine& line : scene::service(scene, source, 0.0).lines) {
    recorded.push_back(find(recording.fields(), scene::name(line.field), file));
    const results::RecordedField& field = recording.fields()[recorded.back()];
    fields.push_back({.name = field.name,
                      .y = field.levels,
                      .x_reference = field.x_reference,
                      .slowness_x = field.slowness_x,
                      .start_time = field.start_time,
                      .time_step = field.time_step,
                      .step_count = field.step_count});
    coupler::validate(fields.back());
    require_cover(fields.back(), scene, source, file);
  }

  coupler::SourceClient client(options, fields);
  client.serve([&](std::size_t f, std::uint64_t step, std::span<double> values) {
    recording.read(recorded[f], step, values);
  });
}

} // namespace

int main(int argc, char** argv) {
  std::string file;
  return tremolo::coupler::participant_main(
      "tremolo-recording", "A recorded free field, as a source.", argc, argv,
      [&](const coupler::ParticipantOptions& options) { run(options, file); },
      {{"--file", "recording (HDF5) to serve; required", file}});
}
