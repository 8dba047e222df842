// tremolo import: what another program computed becomes a recording that can be served.

#include "app/commands.hpp"
#include "app/output_place.hpp"
#include "app/recording/import_motion.hpp"
#include "results/free_field_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace tremolo::app {

namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<fs::path> files;
  fs::path points;
  std::string out;
  std::string velocity_unit;
  std::string stress_unit;
  std::string stress_sign;
  std::string depth_positive;
  std::string vertical_positive;
  std::string depth_unit = "m";
  Conventions conventions;
};

template <class Units>
double size_of(const Units& units, const std::string& name) {
  return std::ranges::find(units, name, &Unit::name)->size;
}

template <class Units>
std::vector<std::string> names(const Units& units) {
  std::vector<std::string> list;
  for (const Unit& unit : units)
    list.emplace_back(unit.name);
  return list;
}

Conventions conventions_from(const Options& options) {
  Conventions conventions = options.conventions;
  conventions.velocity_unit = size_of(velocity_units, options.velocity_unit);
  conventions.stress_unit = size_of(stress_units, options.stress_unit);
  conventions.length_unit = size_of(length_units, options.depth_unit);
  conventions.compression = options.stress_sign == "compression";
  conventions.depth_down = options.depth_positive == "down";
  conventions.vertical_down = options.vertical_positive == "down";
  return conventions;
}

ReadMotion read(const Options& options, bool depth_down) {
  if (options.points.empty())
    return read_motion_csv(options.files, depth_down);
  if (options.files.size() != 2)
    throw std::invalid_argument(
        fmt::format("with --opensees two files are needed, nodal velocities and element stresses; {} given",
                    options.files.size()));
  return read_motion_opensees(options.files[0], options.files[1], options.points, depth_down);
}

void run(const Options& options) {
  std::vector<fs::path> inputs = options.files;
  inputs.push_back(options.points);
  require_writable(options.out, inputs, has_content("free field"));
  const Conventions conventions = conventions_from(options);
  const ReadMotion motion = read(options, conventions.depth_down);
  const coupler::ServedSeries series = field_from(motion, conventions);
  auto findings = check_imported(series, conventions);
  findings.insert(findings.begin(), motion.notes.begin(), motion.notes.end());

  const auto& field = series.field;
  const results::FieldToRecord record{{.name = field.name,
                                       .levels = field.y,
                                       .x_reference = field.x_reference,
                                       .slowness_x = field.slowness_x,
                                       .start_time = field.start_time,
                                       .time_step = field.time_step,
                                       .step_count = field.step_count},
                                      series.values};
  std::string profile;
  for (const auto& finding : findings)
    profile += (profile.empty() ? "" : "; ") + finding;
  results::write_free_field_recording(
      options.out, fmt::format("imported from {}", options.files.front().filename().string()), profile,
      {&record, 1});
  for (const auto& finding : findings)
    fmt::print("{}\n", finding);
  fmt::print("{}: field '{}', {} levels from y = {:.6g} to {:.6g} m, {} times from {:.6g} to {:.6g} s\n",
             options.out, field.name, field.y.size(), field.y.front(), field.y.back(), field.step_count,
             field.start_time, field.end_time());
}

void add_questions(Command& command, Options& options) {
  const std::vector<std::string> up_or_down{"up", "down"};
  command.add_option("--velocity-unit", options.velocity_unit, "Of velocities")
      ->required()
      ->one_of(names(velocity_units));
  command.add_option("--stress-unit", options.stress_unit, "Of stresses")
      ->required()
      ->one_of(names(stress_units));
  command.add_option("--stress-sign", options.stress_sign, "Stresses are positive in tension or compression")
      ->required()
      ->one_of({"tension", "compression"});
  command.add_option("--depth-positive", options.depth_positive, "Depths grow down (depth) or up (level)")
      ->required()
      ->one_of(up_or_down);
  command
      .add_option("--vertical-positive", options.vertical_positive,
                  "Vertical velocities are positive up or down, and the shear stress refers to such an axis")
      ->required()
      ->one_of(up_or_down);
}

void add_settings(Command& command, Options& options) {
  auto& conventions = options.conventions;
  command.add_option("--depth-unit", options.depth_unit, "Of depths")
      ->one_of(names(length_units))
      ->capture_default_str();
  command.add_option("--surface", conventions.surface, "y of depth zero in the case, m")
      ->capture_default_str();
  command
      .add_option("--time-shift", conventions.time_shift,
                  "Added to all times, s; time zero of a case is the start of its shaking")
      ->capture_default_str();
  command
      .add_option("--resample", conventions.resample,
                  "Interpolate to this even step, s, by cubics of third order")
      ->positive();
  command.add_flag("--remove-initial-stress", conventions.remove_initial,
                   "Take the stress of the first time, the static one, away from all");
  command
      .add_option("--density", conventions.density,
                  "Density of the ground, kg/m3, to check units and signs by; without it 1000 to 3000")
      ->positive();
  command
      .add_option("--field", conventions.field,
                  "total (with the free surface) or incident (the upgoing wave alone)")
      ->one_of({"total", "incident"})
      ->capture_default_str();
  command.add_option("--x", conventions.x, "x of the line in the case, m; only with a slowness")
      ->capture_default_str();
  command
      .add_option("--slowness", conventions.slowness_x,
                  "sin(angle)/c of an oblique wave, s/m: at another x the motion is the same, later")
      ->capture_default_str();
}

} // namespace

void add_import(Command& app) {
  auto* command =
      app.add_subcommand("import", "A free field that another program computed, as a recording for model "
                                   "= \"recording\"; units and signs are asked for and checked");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("FILE", options->files,
                   "Comma-separated tables with the header time, depth (or y) and vx, sxy and/or vy, syy "
                   "(and sxx); or, "
                   "with --opensees, the recorder files of nodal velocities and of element stresses")
      ->required()
      ->existing_file();
  command
      ->add_option("--opensees", options->points,
                   "Table kind,tag,depth of the nodes and elements in the order of the recorders' columns")
      ->existing_file();
  command->add_option("--out", options->out, "Written: the recording (HDF5)")->required();
  add_questions(*command, *options);
  add_settings(*command, *options);
  command->callback([options] { run(*options); });
}

} // namespace tremolo::app
