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

/// Of all steps of the levels that are computed together.
constexpr std::size_t most_lot_bytes = std::size_t{32} << 20;

/// The field at all its levels, some at a time, with a sign of life after each piece of time: a long record
/// takes a while.
/// @param done levels of the fields before this one
wavefield::ServedSteps served_steps(const wavefield::LayeredField& field,
                                    const coupler::FieldDescription& served, double done,
                                    coupler::SourceClient& client) {
  const bool incident = served.name == scene::name(scene::BaseForm::incident);
  const wavefield::Part part = incident ? wavefield::Part::incident : wavefield::Part::total;
  const auto points = wavefield::points_on_line(served.x_reference, served.y);
  const wavefield::TimeGrid times{served.start_time, served.time_step, served.step_count};
  const wavefield::LongField whole(field, points, times, part);
  std::vector<std::size_t> pieces;
  for (const wavefield::TimeGrid& piece : whole.pieces())
    pieces.push_back(piece.count);
  const std::size_t level_bytes = pieces.front() * coupler::values_per_point * sizeof(double);
  const std::size_t lot_levels = std::clamp<std::size_t>(most_lot_bytes / level_bytes, 1, levels_per_beat);
  wavefield::ServedSteps steps(points.size(), pieces);
  for (std::size_t begin = 0; begin < points.size(); begin += lot_levels) {
    const auto lot = std::span(points).subspan(begin, std::min(lot_levels, points.size() - begin));
    whole.sample(lot, [&](std::size_t piece, const std::vector<wavefield::History>& histories) {
      steps.put(piece, begin, histories);
      done += static_cast<double>(lot.size() * pieces[piece]) / static_cast<double>(times.count);
      client.beat(done);
    });
  }
  return steps;
}

/// Says in the log what an equivalent-linear iteration did.
wavefield::LayeredField field_of(const scene::Case& scene, const scene::SourceProcess& source) {
  if (source.field.model != scene::SourceModel::eql)
    return wavefield::field_from_case(scene, source);
  const auto result = wavefield::equivalent_linear_from_case(scene, source);
  fmt::print("{}equivalent linear: {}\n", result.converged ? "" : "warning: ", wavefield::summary(result));
  return wavefield::field_from_case(scene, source, result);
}

void run(const coupler::ParticipantOptions& options) {
  const scene::Case scene = scene::load(options.case_file);
  const scene::Plan plan = scene::plan(scene);
  const scene::SourceProcess& source = scene::source_named(plan, options.name);
  if (source.field.model == scene::SourceModel::shaking_table)
    return serve_shaking_table(scene, source, options);
  const wavefield::LayeredField field = field_of(scene, source);
  const double dt = served_interval(scene::motion(scene.motion).highest_frequency());
  const std::vector<coupler::FieldDescription> fields =
      descriptions(scene::service(scene, source, field.slowness_x()), field.slowness_x(), dt);

  coupler::SourceClient client(options, fields);
  coupler::Stopwatch synthesis;
  synthesis.start();
  std::vector<wavefield::ServedSteps> computed;
  computed.reserve(fields.size());
  double levels = 0.0;
  for (const coupler::FieldDescription& served : fields) {
    computed.push_back(served_steps(field, served, levels, client));
    levels += static_cast<double>(served.y.size());
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
