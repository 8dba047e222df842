// tremolo motion: what a strong motion is, its processing, and motions made from a recipe.

#include "app/commands.hpp"
#include "app/motion/chosen.hpp"
#include "app/motion/motion_report.hpp"
#include "app/motion/motion_steps.hpp"
#include "app/motion/record_options.hpp"
#include "app/output_place.hpp"
#include "app/python.hpp"
#include "app/temporary_folder.hpp"
#include "motion/make/recipe.hpp"
#include "motion/plausible.hpp"
#include "motion/read/read_spectrum.hpp"
#include "motion/read/write.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string file;
  std::string recipe;
  RecordOptions read;
  std::string kind;
  std::string as;
  std::string fit = "velocity";
  MotionSteps steps;
  std::string out;
  std::string out_unit;
  std::string response;
  std::string fourier;
  double damping = 0.05;
  std::string picture;
};

/// A motion and how it is called.
struct Named {
  motion::Record record;
  std::string name;
  motion::Title title;
};

Named made(const motion::SynthesisRecipe& recipe, const std::string& name, const std::string& title) {
  auto result = motion::synthesise(recipe);
  const auto& m = result.measures;
  const auto& [filter, envelope] = std::pair(result.recipe.filter, result.recipe.envelope);
  fmt::print("{}: seed {}, {} steps; filter frequency {:.4f} Hz, high_pass {:.4f} Hz, envelope time {:.4f} "
             "s, burst {:.4f}\n",
             name, result.recipe.seed, result.steps, filter.frequency, filter.high_pass, envelope.time,
             envelope.burst);
  return {std::move(result.record),
          name,
          {title.empty() ? "SYNTHETIC MOTION" : title,
           fmt::format("Seed {}: PGA {:.4f} g, PGV {:.4f} m/s, Arias {:.4f} m/s, D5-95 {:.2f} s, Tm {:.4f} s",
                       result.recipe.seed, m.pga / motion::standard_gravity, m.pgv, m.arias,
                       m.significant_duration, m.mean_period)}};
}

Named made(const motion::PulseRecipe& recipe, const std::string& name, const std::string& title) {
  return {motion::sampled(recipe.pulse, recipe.unit, recipe.dt, recipe.count),
          name,
          {title.empty() ? "PULSE" : title, "MADE BY TREMOLO"}};
}

Named the_motion(const Options& options, const motion::ReadAs& as) {
  if (options.recipe.empty()) {
    const fs::path file = options.file;
    return {motion::read_record(file, as), file.string(), {"PROCESSED BY TREMOLO", file.stem().string()}};
  }
  const auto recipe = motion::read_recipe(options.recipe);
  Named result = std::visit(
      [&](const auto& what) { return made(what, fs::path(options.recipe).string(), recipe.title); },
      recipe.what);
  result.record.kind = as.kind ? as.kind : recipe.kind;
  return result;
}

void draw(const Named& named, const Options& options) {
  const TemporaryFolder scratch;
  write_tables(named.record, options.damping, scratch.path());
  if (!options.steps.target.empty())
    write_target_spectrum(motion::read_spectrum(options.steps.target), scratch.path() / "target.csv");
  const int status = run_python("motion-picture", {scratch.path().string(), options.picture, "--title",
                                                   fs::path(named.name).filename().string(), "--damping",
                                                   fmt::format("{}", options.damping)});
  if (status != 0)
    throw std::runtime_error(fmt::format("{}: the picture was not drawn", options.picture));
}

void print_match(const Matched& matched, const MotionSteps& steps) {
  fmt::print("  response spectrum within {:.1f} % of {} after {} steps (scaled alone: {:.1f} %)\n",
             100.0 * matched.after, steps.target, matched.steps, 100.0 * matched.before);
  if (matched.after > motion::MatchSettings{}.tolerance)
    fmt::print(stderr,
               "tremolo: warning: the spectrum is {:.1f} % off at its worst, wanted {:.0f} %: begin with a "
               "motion whose "
               "spectrum has the target's shape\n",
               100.0 * matched.after, 100.0 * motion::MatchSettings{}.tolerance);
}

void require_places(const Options& options) {
  const std::vector<fs::path> inputs{options.file, options.recipe, options.steps.other, options.steps.target};
  if (!options.out.empty())
    require_writable(options.out, inputs, is_written_motion);
  if (!options.response.empty())
    require_writable(options.response, inputs, begins_with(response_heading), "--response");
  if (!options.fourier.empty())
    require_writable(options.fourier, inputs, begins_with(fourier_heading), "--fourier");
  if (!options.picture.empty())
    require_writable(options.picture, inputs, is_picture_of_tremolo, "--plot");
}

void work_on(const Options& options) {
  if (options.file.empty() == options.recipe.empty())
    throw std::invalid_argument("motion: a FILE or --synthesise RECIPE is needed, and not both");
  require_places(options);
  auto as = read_as(options.read);
  as.kind = chosen(options.kind, motion::kind_named, "--kind");
  Named named = the_motion(options, as);
  const std::string overruled = unit_warning(named.record);
  MotionSteps steps = options.steps;
  steps.kind = chosen(options.as, motion::kind_named, "--as");
  steps.fit = options.fit == "velocity" ? motion::BaselineFit::velocity : motion::BaselineFit::displacement;
  steps.target_damping = options.damping;
  auto [record, matched] = processed(std::move(named.record), steps, as);
  named.record = std::move(record);
  if (const auto unit = chosen(options.out_unit, motion::unit_named, "--out-unit"))
    named.record = motion::with_unit(named.record, *unit);

  fmt::print("{}", motion_report(named.record, named.name));
  if (matched)
    print_match(*matched, steps);
  if (!overruled.empty())
    fmt::print(stderr, "tremolo: warning: {}: {}\n", named.name, overruled);
  for (const std::string& doubt : motion::doubts(named.record))
    fmt::print(stderr, "tremolo: warning: {}: {}\n", named.name, doubt);
  if (const auto warning = motion_warning(named.record); !warning.empty())
    fmt::print(stderr, "tremolo: warning: {}: {}\n", named.name, warning);
  if (!options.out.empty())
    motion::write_record(named.record, options.out, named.title);
  if (!options.response.empty())
    write_response_spectrum(named.record, options.damping, options.response);
  if (!options.fourier.empty())
    write_fourier_spectrum(named.record, options.fourier);
  if (!options.picture.empty())
    draw(named, options);
}

void add_reading(Command& command, Options& options) {
  command.add_option("FILE", options.file, record_formats);
  command.add_option(
      "--synthesise", options.recipe,
      "Make the motion of this TOML recipe instead: a [pulse], or noise with the measures of [target]");
  add_record_options(command, options.read);
  command.add_option("--kind", options.kind, "incident, outcrop or within: what it is the motion of");
}

void add_steps(Command& command, Options& options) {
  MotionSteps& steps = options.steps;
  auto* rotate = command.add_option("--rotate", steps.rotate_deg,
                                    "1. Component along an axis at DEG degrees from this one towards --with");
  auto* with = command.add_option("--with", steps.other, "   File of the perpendicular component");
  command
      .add_option("--with-component", steps.other_component,
                  "   Its component or column, where the file has several")
      ->needs(with);
  rotate->needs(with);
  with->needs(rotate);
  auto* baseline = command.add_option(
      "--baseline", steps.baseline,
      "2. Subtract the baseline: degree of the polynomial fitted; the velocity ends at zero");
  command.add_option("--baseline-fit", options.fit, "   What it is fitted to")
      ->one_of({"velocity", "displacement"})
      ->needs(baseline)
      ->capture_default_str();
  command.add_option("--taper", steps.taper, "3. Half a cosine over this time at each end, s");
  auto* band =
      command
          .add_option("--band", steps.band, "4. Zero-phase Butterworth: low and high corner, Hz; 0 is open")
          ->expected(2)
          ->delimiter(',');
  command.add_option("--order", steps.order, "   Order of its two filters")
      ->needs(band)
      ->capture_default_str();
  command.add_option("--resample", steps.step, "5. Band-limited interpolation to this step, s");
  auto* scale = command.add_option("--scale", steps.scale, "6. Factor");
  auto* pga = command.add_option("--pga", steps.pga, "6. Scale to this PGA, m/s2");
  pga->excludes(scale);
  command
      .add_option("--match", steps.target,
                  "6. Bring the response spectrum at --damping to that of this table: columns period (s) and "
                  "acceleration (m/s2) or acceleration_g")
      ->excludes(scale)
      ->excludes(pga);
  command.add_option("--shift", steps.shift, "7. Later by this time, s (negative: earlier)");
  command.add_option("--as", options.as,
                     "8. Make it incident or outcrop (vertical incidence: outcrop = 2 x incident)");
}

void add_writing(Command& command, Options& options) {
  command.add_option("--out", options.out, "Written: the motion as .AT2 (g), .VT2 (cm/s), .DT2 (cm) or .csv");
  command.add_option("--out-unit", options.out_unit, "Unit, and by it quantity, of the report and of .csv");
  command.add_option(
      "--response", options.response,
      "Written: response spectrum (CSV, SI) at PEER's 105 periods from 0.01 to 10 s and 200 even on a "
      "logarithmic axis");
  command.add_option("--fourier", options.fourier,
                     "Written: Fourier amplitudes of the acceleration (CSV, SI)");
  command.add_option("--damping", options.damping, "Damping of the response spectrum, of critical")
      ->between(0.0, 0.99)
      ->capture_default_str();
  command.add_option("--plot", options.picture, "Picture of histories and spectra (default motion.png)")
      ->expected(0, 1)
      ->default_str("motion.png");
}

} // namespace

void add_motion(Command& app) {
  auto* command =
      app.add_subcommand("motion", "Measures, spectra, processing and synthesis of strong motions");
  command->footer("The steps are done in the order of their numbers.");
  const auto options = std::make_shared<Options>();
  add_reading(*command, *options);
  add_steps(*command, *options);
  add_writing(*command, *options);
  command->callback([options] { work_on(*options); });
}

} // namespace tremolo::app
