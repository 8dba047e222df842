// tremolo wave: the exact field of the case's incident wave in the half-space, as a table.

#include "app/commands.hpp"
#include "app/points_file.hpp"
#include "scene/case.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

namespace tremolo::app {
namespace {

struct Options {
  std::string scene;
  std::string points;
  std::string times;
  std::string out;
};

/// Points whose histories are held at once; it bounds the memory, not the answer.
constexpr std::size_t points_at_once = 64;

void write_rows(std::ostream& stream, const wavefield::Point& point, const wavefield::TimeGrid& times,
                const wavefield::History& h) {
  for (std::size_t i = 0; i < times.count; ++i)
    stream << fmt::format("{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g}\n",
                          times.start + static_cast<double>(i) * times.dt, point.x, point.y, h.ux[i], h.uy[i],
                          h.vx[i], h.vy[i], h.sxx[i], h.syy[i], h.sxy[i]);
}

void require_homogeneous(const scene::Case& scene) {
  if (!scene.profile.empty())
    throw std::runtime_error(fmt::format("{}: the free field has a [[profile]] of {} layers; the exact field "
                                         "is that of a homogeneous half-space",
                                         scene.file.string(), scene.profile.size()));
}

void write_field(const Options& options) {
  const scene::Case scene = scene::load_free_field(options.scene);
  require_homogeneous(scene);
  const auto points = read_points(options.points, scene.surface_level);
  const auto times = parse_times(options.times);
  const auto field = wavefield::elastic_field(scene, scene.profile, scene.surface_level);

  std::ofstream stream(options.out);
  stream << "t,x,y,ux,uy,vx,vy,sxx,syy,sxy\n";
  for (std::size_t begin = 0; begin < points.size() && stream; begin += points_at_once) {
    const auto some = std::span(points).subspan(begin, std::min(points_at_once, points.size() - begin));
    const auto histories = field.sample(some, times);
    for (std::size_t i = 0; i < some.size(); ++i)
      write_rows(stream, some[i], times, histories[i]);
  }
  stream.close();
  if (!stream)
    throw std::runtime_error(fmt::format("{}: cannot be written", options.out));
  fmt::print("{}: {} points x {} times\n", options.out, points.size(), times.count);
}

} // namespace

void add_wave(CLI::App& app) {
  auto* command = app.add_subcommand("wave", "The exact wavefield of a case at points and times of your own");
  const auto options = std::make_shared<Options>();
  command->add_option("CASE", options->scene, "Case file; needs [motion], [surface] and [halfspace]")
      ->required();
  command->add_option("--points", options->points, "Points: header x,y, one point (m) a line")->required();
  command->add_option("--times", options->times, "Times T0:T1:DT in s, both ends included")->required();
  command
      ->add_option("--out", options->out,
                   "Written: t,x,y,ux,uy,vx,vy,sxx,syy,sxy in SI units, point by point; stresses are the "
                   "dynamic part, tension positive")
      ->required();
  command->callback([options] { write_field(*options); });
}

} // namespace tremolo::app
