// tremolo deconvolve: the motion of rock under a case's ground from one that was recorded in it.

#include "app/commands.hpp"
#include "app/free_field/deconvolution.hpp"
#include "app/motion/motion_report.hpp"
#include "app/motion/record_options.hpp"
#include "app/output_place.hpp"
#include "app/python.hpp"
#include "app/temporary_folder.hpp"
#include "motion/plausible.hpp"
#include "motion/read/read.hpp"
#include "motion/read/write.hpp"
#include "scene/ground.hpp"
#include "scene/plan/plan.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::app {
namespace {

namespace fs = std::filesystem;
using motion::MotionKind;

struct Options {
  std::string scene;
  std::string file;
  std::string model;
  std::string side;
  RecordOptions read;
  double depth = 0.0;
  double cutoff = 15.0;
  std::string as;
  std::string out;
  bool plot = false;
};

motion::Record record_of(const Options& options) {
  auto record = motion::read_record(options.file, read_as(options.read));
  if (record.kind == MotionKind::incident || record.kind == MotionKind::outcrop)
    throw std::invalid_argument(
        fmt::format("{}: it says that it is an {} motion, which has no layers above it: "
                    "to deconvolve needs one that was recorded in the ground",
                    options.file, motion::name(*record.kind)));
  if (const double nyquist = 0.5 / record.dt; !(options.cutoff <= nyquist))
    throw std::invalid_argument(
        fmt::format("--cutoff: {} Hz, must be at most {} Hz, the highest frequency of a "
                    "record at steps of {} s",
                    options.cutoff, nyquist, record.dt));
  return record;
}

/// The kind that is written: what the case takes, unless given.
MotionKind kind_of(const Options& options, const scene::Case& scene) {
  if (!options.as.empty())
    return *motion::kind_named(options.as);
  if (scene.motion.kind == MotionKind::within)
    throw std::invalid_argument(fmt::format(
        "{}: [motion] kind is within, and a record of the ground becomes an outcrop or incident motion: --as "
        "outcrop or --as incident says which",
        options.scene));
  return scene.motion.kind;
}

/// The ground below the record: that of [[profile]] under [surface], or of a side.
struct Ground {
  scene::Case scene;
  scene::SourceProcess source;
};

Ground ground_of(const Options& options) {
  const auto model = options.model == "eql" ? scene::SourceModel::eql : scene::SourceModel::wave;
  const scene::FreeFieldModel field{model, {}};
  if (options.side.empty()) {
    auto scene = scene::load_ground(options.scene, model, std::nullopt);
    const double surface = scene.surface_level;
    return {std::move(scene), {.name = "column", .field = field, .surface = surface}};
  }
  const auto side = options.side == "right" ? scene::Side::right : scene::Side::left;
  auto scene = scene::load_ground(options.scene, model, side);
  const scene::LateralBoundary& at = side == scene::Side::right ? scene.boundary.right : scene.boundary.left;
  scene::SourceProcess source{.name = "column", .field = field, .surface = at.surface};
  if (!at.own_profile.empty())
    source.profile = side;
  return {std::move(scene), std::move(source)};
}

fs::path picture_of(const Options& options) {
  return fs::path(options.out).replace_extension(".png");
}

void draw(const DeconvolvedMotion& motion, const motion::Record& written, const Options& options) {
  constexpr double damping = 0.05;
  const TemporaryFolder scratch;
  for (const auto& [record, name] : {std::pair(&motion.recorded, "record"), std::pair(&written, "written")}) {
    write_tables(*record, damping, scratch.path() / name);
  }
  const fs::path picture = picture_of(options);
  const int status = run_python(
      "deconvolution-picture",
      {scratch.path().string(), picture.string(), "--kind", std::string(motion::name(*written.kind)),
       "--lead", fmt::format("{}", motion.lead), "--cutoff", fmt::format("{}", options.cutoff), "--title",
       fmt::format("{} through {}, model {}", fs::path(options.file).filename().string(),
                   fs::path(options.scene).filename().string(), options.model)});
  if (status != 0)
    throw std::runtime_error(fmt::format("{}: the picture was not drawn", picture.string()));
}

void run(const Options& options) {
  const auto [scene, source] = ground_of(options);
  const MotionKind kind = kind_of(options, scene);
  const GroundRecord given{record_of(options), options.depth, options.cutoff};
  fmt::print("{}", scene::remarks_text(scene));
  for (const std::string& note : scene::linearised_soils(scene, source))
    fmt::print("{}\n", note);
  const DeconvolvedMotion motion = deconvolved(scene, source, given);
  const motion::Record& written = kind == MotionKind::incident ? motion.incident : motion.outcrop;
  motion::write_record(written, options.out,
                       {"DECONVOLVED BY TREMOLO", fs::path(options.file).stem().string()});
  fmt::print("{}: {} motion, {} samples every {} s, model {}\n{}", options.out, motion::name(kind),
             written.samples.size(), written.dt, options.model, deconvolution_report(motion, given));
  if (const std::string warning = unit_warning(given.record); !warning.empty())
    fmt::print(stderr, "tremolo: warning: {}: {}\n", options.file, warning);
  for (const std::string& warning : motion.warnings)
    fmt::print(stderr, "tremolo: warning: {}\n", warning);
  if (const std::string warning = motion_warning(written); !warning.empty())
    fmt::print(stderr, "tremolo: warning: {}: {}\n", options.out, warning);
  if (options.plot)
    draw(motion, written, options);
}

} // namespace

void add_deconvolve(Command& app) {
  auto* command =
      app.add_subcommand("deconvolve", "The motion of rock under a case's ground from a record of "
                                       "its surface or of a sensor within it");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("CASE", options->scene,
                   "Case file; needs [motion] (whose file need not be there yet), [surface], [halfspace] and "
                   "[[profile]]")
      ->required();
  command->add_option("RECORD", options->file, fmt::format("The record: {}", record_formats))->required();
  command
      ->add_option("--model", options->model,
                   "wave: layers at small strain; eql: equivalent linear, iterated under the record")
      ->required()
      ->one_of({"wave", "eql"});
  command
      ->add_option("--side", options->side,
                   "left or right: the layers and surface of this side's free field (default: [[profile]] "
                   "under [surface])")
      ->one_of({"left", "right"});
  add_record_options(*command, options->read);
  command->add_option("--depth", options->depth, "Depth of the sensor below the surface, m")
      ->non_negative()
      ->capture_default_str();
  command
      ->add_option("--cutoff", options->cutoff,
                   "The record is taken whole up to this frequency, Hz, and not at all above 1.25 times it")
      ->positive()
      ->capture_default_str();
  command
      ->add_option("--as", options->as,
                   "incident or outcrop: what is written (default: what [motion] kind says)")
      ->one_of({"incident", "outcrop"});
  command
      ->add_option("--out", options->out,
                   "Written: the acceleration of the rock as .AT2 (g) or .csv (m/s2), .VT2 or .DT2")
      ->required();
  command->add_flag("--plot", options->plot, "Draw OUT.png beside the file");
  command->callback([options] {
    const std::vector<fs::path> inputs{options->scene, options->file};
    require_writable(options->out, inputs, is_written_motion);
    if (options->plot)
      require_writable(picture_of(*options), inputs, is_picture_of_tremolo, "--plot");
    run(*options);
  });
}

} // namespace tremolo::app
