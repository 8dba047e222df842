// tremolo-wave: serves the free field of an oblique P or SV wave in elastic or equivalent-linear layers,
// computed at once for the whole run on a vertical line; along x it is the same, delayed by the horizontal
// slowness. A shaking table is served as it moves.

#include "coupler/participant.hpp"
#include "scene/case.hpp"
#include "scene/plan/service.hpp"
#include "scene/plan/wave/motion.hpp"
#include "wavefield/layers/long_field.hpp"
#include "wavefield/process/descriptions.hpp"
#include "wavefield/process/field_from_case.hpp"
#include "wavefield/process/served_steps.hpp"
#include "wavefield/process/shaking_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::wavefield {

namespace {

/// Levels computed between two signs of life.
constexpr std::size_t levels_per_beat = 32;

/// Limit on the memory for all steps of the levels that are computed together.
constexpr std::size_t most_lot_bytes = std::size_t{32} << 20;

/// A plane wave as it is served.
struct Served {
  const LayeredField& field;
  Part part;
  coupler::FieldDescription description;
};

/// A field at all its levels, some at a time, with a sign of life after each piece of time: a long record
/// takes a while.
/// @param done levels of the fields before this one
ServedSteps served_steps(const Served& served, double done, coupler::SourceClient& client) {
  const auto& [field, part, description] = served;
  const auto points = points_on_line(description.x_reference, description.y);
  const TimeGrid times{description.start_time, description.time_step, description.step_count};
  const LongField whole(field, points, times, part);
  std::vector<std::size_t> pieces;
  for (const TimeGrid& piece : whole.pieces())
    pieces.push_back(piece.count);
  const std::size_t level_bytes = pieces.front() * coupler::values_per_point * sizeof(double);
  const std::size_t lot_levels = std::clamp<std::size_t>(most_lot_bytes / level_bytes, 1, levels_per_beat);
  ServedSteps steps(points.size(), pieces);
  for (std::size_t begin = 0; begin < points.size(); begin += lot_levels) {
    const auto lot = std::span(points).subspan(begin, std::min(lot_levels, points.size() - begin));
    whole.sample(lot, [&](std::size_t piece, const std::vector<History>& histories) {
      steps.put(piece, begin, histories);
      done += static_cast<double>(lot.size() * pieces[piece]) / static_cast<double>(times.count);
      client.beat(done);
    });
  }
  return steps;
}

/// Says in the log what an equivalent-linear iteration did.
Superposition field_of(const scene::Case& scene, const scene::SourceProcess& source) {
  if (source.field.model != scene::SourceModel::eql)
    return field_from_case(scene, source);
  const auto result = equivalent_linear_from_case(scene, source);
  fmt::print("{}equivalent linear: {}\n", result.converged ? "" : "warning: ", summary(result));
  return field_from_case(scene, source, result);
}

/// Plane waves have slownesses of their own, so each is served by itself; a face takes their sum.
std::vector<Served> served_fields(const Superposition& field, const scene::Case& scene,
                                  const scene::SourceProcess& source) {
  const auto waves = scene.plane_waves();
  std::vector<Served> all;
  for (std::size_t w = 0; w < waves.size(); ++w) {
    const LayeredField& wave = field.waves()[w];
    const scene::Service service = scene::service(scene, source, wave.slowness_x());
    const double dt = served_interval(scene::motion(*waves[w]).highest_frequency());
    const auto fields = descriptions(service, wave.slowness_x(), dt, scene::suffix_of_wave(w));
    for (std::size_t i = 0; i < fields.size(); ++i)
      all.push_back({wave, service.lines[i].field == scene::BaseForm::incident ? Part::incident : Part::total,
                     fields[i]});
  }
  return all;
}

void run(const coupler::ParticipantOptions& options) {
  const scene::Case scene = scene::load(options.case_file);
  const scene::Plan plan = scene::plan(scene);
  const scene::SourceProcess& source = scene::source_named(plan, options.name);
  if (source.field.model == scene::SourceModel::shaking_table)
    return serve_shaking_table(scene, source, options);
  const Superposition field = field_of(scene, source);
  const std::vector<Served> served = served_fields(field, scene, source);
  std::vector<coupler::FieldDescription> fields;
  fields.reserve(served.size());
  for (const Served& one : served)
    fields.push_back(one.description);

  coupler::SourceClient client(options, fields);
  coupler::Stopwatch synthesis;
  synthesis.start();
  std::vector<ServedSteps> computed;
  computed.reserve(fields.size());
  double levels = 0.0;
  for (const Served& one : served) {
    computed.push_back(served_steps(one, levels, client));
    levels += static_cast<double>(one.description.y.size());
  }
  synthesis.stop();

  client.serve(
      [&](std::size_t f, std::uint64_t step, std::span<double> values) { computed[f].read(step, values); },
      {{"Fourier synthesis", synthesis.seconds()}});
}

} // namespace
} // namespace tremolo::wavefield

int main(int argc, char** argv) {
  return tremolo::coupler::participant_main("tremolo-wave",
                                            "The exact free field of an oblique wave, as a source.", argc,
                                            argv, tremolo::wavefield::run);
}
