// tremolo wave: the exact plane-wave field of a case's elastic ground as a table, in time at points of one's
// own, or as transfer functions of its surface.

#include "app/commands.hpp"
#include "app/free_field/points_file.hpp"
#include "app/output_place.hpp"
#include "base/text/text_file.hpp"
#include "scene/case.hpp"
#include "scene/text/files.hpp"
#include "wavefield/layers/transfer.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::app {
namespace {

struct Options {
  std::string scene;
  std::string points;
  std::string times;
  std::string out;
  std::string frequencies = "0.05:25:0.05";
  bool transfer = false;
  bool wrap_around = false;
};

constexpr const char* field_heading = "t,x,y,ux,uy,vx,vy,sxx,syy,sxy\n";
constexpr const char* transfer_heading =
    "frequency_hz,re_ux,im_ux,re_uy,im_uy,re_within_ux,im_within_ux,re_within_uy,im_within_uy,"
    "re_to_outcrop,im_to_outcrop,re_to_within,im_to_within\n";

/// Points whose histories are held at once; it bounds the memory, not the answer.
constexpr std::size_t points_at_once = 64;

void write_rows(TextFile& table, const wavefield::Point& point, const wavefield::TimeGrid& times,
                const wavefield::History& h) {
  for (std::size_t i = 0; i < times.count; ++i)
    table.add(fmt::format("{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g}\n",
                          times.start + static_cast<double>(i) * times.dt, point.x, point.y, h.ux[i], h.uy[i],
                          h.vx[i], h.vy[i], h.sxx[i], h.syy[i], h.sxy[i]));
}

void print_wrap_around(const wavefield::Superposition& field, std::span<const wavefield::Point> points,
                       const wavefield::TimeGrid& times) {
  for (const wavefield::LayeredField& wave : field.waves()) {
    const wavefield::WrapAroundError error = wave.wrap_around_error(points, times);
    fmt::print(
        "window of {:.4g} s; doubled, it changes displacement by {:.1e}, velocity by {:.1e}, stress by "
        "{:.1e} of their peaks\n",
        error.window, error.displacement, error.velocity, error.stress);
  }
}

void write_field(const Options& options, const scene::Case& scene) {
  const auto points = read_points(options.points, scene.surface_level);
  const auto times = parse_times(options.times);
  const auto field = wavefield::elastic_field(scene, scene.profile, scene.surface_level);
  const wavefield::Quantities quantities{.strain = false, .rates = false};

  TextFile table(options.out);
  table.add(field_heading);
  for (std::size_t begin = 0; begin < points.size(); begin += points_at_once) {
    const auto some = std::span(points).subspan(begin, std::min(points_at_once, points.size() - begin));
    const auto histories = field.sample(some, times, wavefield::Part::total, quantities);
    for (std::size_t i = 0; i < some.size(); ++i)
      write_rows(table, some[i], times, histories[i]);
  }
  table.close();
  fmt::print("{}: {} points x {} times\n", options.out, points.size(), times.count);
  if (options.wrap_around)
    print_wrap_around(field, points, times);
}

void write_transfer(const Options& options, const scene::Case& scene) {
  const auto frequencies = parse_frequencies(options.frequencies);
  const auto ground = wavefield::ground_from_case(scene, scene.profile);
  const auto incidence = wavefield::incidence_of(scene.motion);
  const auto rows = wavefield::surface_transfer(ground, incidence.wave, incidence.angle_rad, frequencies);

  TextFile table(options.out);
  table.add(transfer_heading);
  for (const wavefield::SurfaceTransfer& row : rows) {
    table.add(fmt::format("{:.12g}", row.frequency_hz));
    for (const std::complex<double> value :
         {row.surface.ux, row.surface.uy, row.within.ux, row.within.uy, row.to_outcrop, row.to_within})
      table.add(fmt::format(",{:.12g},{:.12g}", value.real(), value.imag()));
    table.add("\n");
  }
  table.close();
  fmt::print("{}: {} frequencies\n", options.out, rows.size());
}

void run(const Options& options) {
  if (!options.transfer && (options.points.empty() || options.times.empty()))
    throw std::invalid_argument("tremolo wave needs --points and --times, or --transfer");
  const scene::Case scene = scene::load_free_field(options.scene, scene::SourceModel::wave);
  std::vector<std::filesystem::path> inputs = scene::data_files(scene);
  inputs.insert(inputs.end(), {options.scene, options.points});
  require_writable(options.out, inputs, [](const std::filesystem::path& file) {
    return begins_with(field_heading)(file) || begins_with(transfer_heading)(file);
  });
  if (options.transfer)
    write_transfer(options, scene);
  else
    write_field(options, scene);
}

} // namespace

void add_wave(Command& app) {
  auto* command =
      app.add_subcommand("wave", "The exact wavefield of a case at points and times of your own, or its "
                                 "transfer functions");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("CASE", options->scene,
                   "Case file; needs [motion], [surface] and [halfspace], takes [[profile]] and [damping]")
      ->required();
  auto* points = command->add_option("--points", options->points, "Points: header x,y, one point (m) a line");
  auto* times = command->add_option("--times", options->times, "Times T0:T1:DT in s, both ends included");
  points->needs(times);
  times->needs(points);
  command
      ->add_option("--out", options->out,
                   "Written: t,x,y,ux,uy,vx,vy,sxx,syy,sxy in SI units, point by point; stresses are the "
                   "dynamic part, tension positive. With --transfer: complex amplitudes under the wave of "
                   "[motion], time kernel exp(+i omega t), of surface and top of the half-space per unit "
                   "incident displacement there, and of the surface over outcrop and within motion "
                   "(horizontal for SV, vertical for P)")
      ->required();
  auto* transfer =
      command->add_flag("--transfer", options->transfer, "Transfer functions instead of histories");
  transfer->excludes(points);
  command->add_option("--frequencies", options->frequencies, "Frequencies F0:F1:DF in Hz, both ends included")
      ->capture_default_str()
      ->needs(transfer);
  command
      ->add_flag("--wrap-around", options->wrap_around,
                 "Say what changes when the time window of the Fourier synthesis is doubled")
      ->needs(points);
  command->callback([options] { run(*options); });
}

} // namespace tremolo::app
