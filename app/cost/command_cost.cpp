// tremolo cost: what accuracy costs on a case, and which setting buys it cheapest.

#include "app/commands.hpp"
#include "app/cost/cost_ladder.hpp"
#include "app/cost/cost_report.hpp"
#include "app/free_field/table_text.hpp"
#include "app/output_place.hpp"
#include "app/python.hpp"
#include "app/run/local_options.hpp"
#include "app/study/differences.hpp"
#include "app/verify/exact_field.hpp"
#include "app/verify/verification.hpp"
#include "base/text/text_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

struct Options {
  std::string case_file;
  std::vector<std::string> knobs;
  std::optional<std::string> target;
  fs::path reference;
  fs::path out;
  int threads = 1;
};

/// "1%" or "0.01".
double target_from(const std::string& text) {
  const bool in_percent = text.ends_with('%');
  const auto value = finite_number(trimmed(in_percent ? text.substr(0, text.size() - 1) : text));
  const double target = value.value_or(0.0) / (in_percent ? 100.0 : 1.0);
  if (!(target > 0.0 && target < 1.0))
    throw std::invalid_argument(
        fmt::format("--target {}: write a relative error between 0 and 1, such as 1% or 0.01", text));
  return target;
}

/// The costs of a finished rung. The file lies in the rung's folder and shows that the run need not be
/// repeated.
fs::path cost_file(const fs::path& folder) {
  return folder / "rung.json";
}

/// Reads the costs of a rung; false where it has not run to its end.
bool read_cost(const fs::path& folder, CostRung& rung) {
  if (!fs::exists(cost_file(folder)))
    return false;
  const fs::path case_file = folder / "case.toml";
  if (!fs::exists(case_file) || read_text_file(case_file) != rung.variant.text)
    throw std::runtime_error(
        fmt::format("{} holds a run of another text of the case; choose another --out, or remove the folder",
                    folder.string()));
  const auto json = nlohmann::json::parse(read_text_file(cost_file(folder)), nullptr, false);
  const auto number = [&](const char* key) {
    if (!json.is_object() || !json.contains(key) || !json[key].is_number() || json[key].get<double>() < 0.0)
      throw std::runtime_error(fmt::format("{} is damaged; remove its folder, and the run is made again",
                                           cost_file(folder).string()));
    return json[key].get<double>();
  };
  rung.point.cpu = number("cpu_s");
  rung.point.work = number("updates");
  return true;
}

void run(const fs::path& folder, int threads, CostRung& rung) {
  if (fs::exists(folder) && !fs::exists(folder / "case.toml"))
    throw std::runtime_error(
        fmt::format("{} holds no run; choose another --out, or remove the folder", folder.string()));
  fs::remove_all(folder); // of a run that did not end
  const RunCost cost = run_variant(rung.variant, folder, threads);
  rung.point.cpu = cost.sources + cost.domain;
  rung.point.work = cost.updates;
  const nlohmann::ordered_json json = {{"cpu_s", rung.point.cpu}, {"updates", rung.point.work}};
  write_text_file(cost_file(folder), json.dump() + "\n");
}

/// Refused before anything runs: a ladder none of whose rungs is a case.
void require_rungs(const CostStudy& study) {
  std::string text = "no rung of the ladder is a case that can run:";
  for (const CostRung& rung : study.rungs) {
    if (rung.variant.scene)
      return;
    text += fmt::format("\n  {}: {}", setting(study.knobs, rung.variant.values), rung.variant.refused);
  }
  std::fprintf(stderr, "tremolo: %s\n", text.c_str());
  throw Exit{refused};
}

CostStudy study_of(const scene::Case& given, std::vector<scene::Axis> knobs) {
  CostStudy study{.title = given.title, .knobs = std::move(knobs), .rungs = {}};
  for (Variant& variant : ladder(given, study.knobs)) {
    CostRung& rung = study.rungs.emplace_back(CostRung{.variant = std::move(variant)});
    if (rung.variant.scene)
      rung.point = {.family = family(study.knobs, rung.variant.values),
                    .size = rung.variant.scene->mesh.size};
  }
  return study;
}

/// Fills in the errors, and says what they are relative to.
std::string measure(std::vector<CostRung>& rungs, const Options& options) {
  const bool exact = options.reference.empty() && std::ranges::all_of(rungs, [](const CostRung& rung) {
                       return !rung.variant.scene || !why_not_exact(*rung.variant.scene);
                     });
  fs::path reference = options.reference;
  if (!exact && reference.empty()) {
    const auto finest =
        std::ranges::max_element(rungs, {}, [](const CostRung& rung) { return rung.point.work; });
    reference = options.out / finest->variant.name;
  }
  for (CostRung& rung : rungs) {
    const fs::path folder = options.out / rung.variant.name;
    rung.reference = !exact && rung.variant.scene && fs::equivalent(folder, reference);
    if (!rung.measured())
      continue;
    const results::RunReader run(folder / "run.h5");
    if (exact) {
      const Agreement whole = verify(run, *rung.variant.scene).particles.regions.front();
      rung.point.error = whole.relative_l2;
      rung.phase_lag = whole.phase_lag;
    } else {
      rung.point.error = difference_at_monitors(run, results::RunReader(reference / "run.h5"));
    }
  }
  if (exact)
    return "particle velocity against the exact field, relative L2 over all particles and frames";
  return fmt::format(
      "velocity at the monitors against the run {}, which has an error of its own, relative L2",
      reference.filename().string());
}

void mark_front(std::vector<CostRung>& rungs) {
  std::vector<CostPoint> points;
  std::vector<CostRung*> measured;
  for (CostRung& rung : rungs)
    if (rung.measured()) {
      points.push_back(rung.point);
      measured.push_back(&rung);
    }
  for (const std::size_t i : pareto_front(points))
    measured[i]->front = true;
}

/// The family whose fit reaches the target in the least time.
std::optional<CostPrediction> predict(const scene::Case& given, const CostStudy& study) {
  if (std::ranges::find(study.knobs, size_key, &scene::Axis::key) == study.knobs.end())
    return std::nullopt;
  std::optional<CostPrediction> best;
  for (const CostFit& fit : study.fits) {
    const auto wanted = size_for(fit, *study.target);
    if (!wanted)
      continue;
    const auto member =
        std::ranges::find(study.rungs, fit.family, [](const CostRung& rung) { return rung.point.family; });
    const auto size = admissible_size(given, study.knobs, member->variant.values, *wanted);
    if (size && (!best || fit.cpu_at(*size) < best->fit.cpu_at(best->size)))
      best = {fit, *size};
  }
  return best;
}

void study_cost(const Options& options) {
  const auto given = scene::load(options.case_file);
  const auto target = options.target ? std::optional(target_from(*options.target)) : std::nullopt;
  std::vector<scene::Axis> knobs;
  std::ranges::transform(options.knobs, std::back_inserter(knobs), knob_from);
  CostStudy study = study_of(given, knobs.empty() ? default_knobs(given) : knobs);
  require_rungs(study);
  make_folder(options.out);
  require_writable_in(options.out,
                      {{"cost.json", has_words("\"error_of\": ")},
                       {"cost.csv", has_words("relative_error,phase_lag_s,cpu_s,")},
                       {"cost.png", is_picture_of_tremolo}},
                      {options.case_file});
  for (CostRung& rung : study.rungs)
    if (const fs::path folder = options.out / rung.variant.name;
        rung.variant.scene && !read_cost(folder, rung))
      run(folder, options.threads, rung);
  study.error_of = measure(study.rungs, options);
  mark_front(study.rungs);
  study.fits = fits(study.points());
  study.target = target;
  if (target)
    study.prediction = predict(given, study);
  write_text_file(options.out / "cost.json", cost_json(study));
  fmt::print("\n");
  if (run_python("cost-table", {options.out.string()}) != 0)
    throw Exit{1};
}

} // namespace

void add_cost(Command& app) {
  auto* command = app.add_subcommand(
      "cost",
      "Run a case with several settings: error against CPU time, and the cheapest for a wanted error");
  const auto options = std::make_shared<Options>();
  command->add_option("CASE", options->case_file, "Case file")->required();
  command
      ->add_option(
          "--knob", options->knobs,
          "KEY=VALUE,VALUE: a key of the case and its values, such as mesh.size=1,0.5; 'none' is the "
          "case without the key; 'width' moves the sides (m). Several knobs: every combination. "
          "Without any: transfer, step and three cell sizes")
      ->one_at_a_time();
  command->add_option("--target", options->target,
                      "Wanted error, such as 1%: which setting, for how much time");
  command
      ->add_option(
          "--reference", options->reference,
          "Folder of a run of the case that the monitors are held against, instead of the exact field or, "
          "where that is not known, of the rung with the most particle updates")
      ->existing_folder();
  command
      ->add_option(
          "--out", options->out,
          "Folder: one run a rung, cost.csv, cost.json and cost.png. Finished rungs in it are not run again")
      ->required();
  command->add_option("--threads", options->threads, "Threads of the domain")
      ->between(1, most_threads)
      ->capture_default_str();
  command->callback([options] { study_cost(*options); });
}

} // namespace tremolo::app
