// tremolo cost: what accuracy costs on a case, and which setting buys it cheapest.

#include "app/commands.hpp"
#include "app/cost/cost_error.hpp"
#include "app/cost/cost_report.hpp"
#include "app/free_field/table_text.hpp"
#include "app/output_place.hpp"
#include "app/python.hpp"
#include "app/run/case_run.hpp"
#include "app/run/local_options.hpp"
#include "app/verify/exact_field.hpp"
#include "base/text_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
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

/// Cost of a finished rung. The file lies in the rung's folder and shows that the run need not be repeated.
struct Cost {
  double cpu = 0.0;  ///< s
  double work = 0.0; ///< particle updates
};

fs::path cost_file(const fs::path& folder) {
  return folder / "rung.json";
}

std::optional<Cost> finished(const fs::path& folder, const std::string& text) {
  if (!fs::exists(cost_file(folder)))
    return std::nullopt;
  const fs::path case_file = folder / "case.toml";
  if (!fs::exists(case_file) || read_text_file(case_file) != text)
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
  return Cost{number("cpu_s"), number("updates")};
}

Cost run_rung(const Rung& rung, const fs::path& folder, int threads) {
  if (fs::exists(folder) && !fs::exists(folder / "case.toml"))
    throw std::runtime_error(
        fmt::format("{} holds no run; choose another --out, or remove the folder", folder.string()));
  fs::remove_all(folder); // of a run that did not end
  Cost cost;
  for (const auto& process :
       run_case(*rung.scene, {.folder = folder, .mode = {}, .transport = "ipc", .threads = threads})) {
    cost.cpu += process.cpu_seconds;
    cost.work += process.report.particle_updates;
  }
  write_text_file(cost_file(folder),
                  nlohmann::ordered_json{{"cpu_s", cost.cpu}, {"updates", cost.work}}.dump() + "\n");
  return cost;
}

/// Refused before anything runs: a ladder none of whose rungs is a case.
void require_rungs(const std::vector<Rung>& rungs, const std::vector<Knob>& knobs) {
  if (std::ranges::any_of(rungs, [](const Rung& rung) { return rung.refused.empty(); }))
    return;
  std::string text = "no rung of the ladder is a case that can run:";
  for (const Rung& rung : rungs)
    text += fmt::format("\n  {}: {}", setting(knobs, rung.values), rung.refused);
  std::fprintf(stderr, "tremolo: %s\n", text.c_str());
  throw Exit{refused};
}

std::vector<CostRung> run_ladder(const std::vector<Rung>& rungs, const std::vector<Knob>& knobs,
                                 const Options& options) {
  std::vector<CostRung> all;
  for (const Rung& rung : rungs) {
    CostRung entry{.values = rung.values, .folder = folder_name(knobs, rung.values), .refused = rung.refused};
    if (rung.scene) {
      const fs::path folder = options.out / entry.folder;
      const auto known = finished(folder, rung.text);
      const Cost cost = known ? *known : run_rung(rung, folder, options.threads);
      entry.point = {.family = setting(knobs, rung.values, size_key),
                     .size = rung.scene->mesh.size,
                     .cpu = cost.cpu,
                     .work = cost.work};
    }
    all.push_back(std::move(entry));
  }
  return all;
}

/// Fills in the errors, and says what they are relative to.
std::string measure(std::vector<CostRung>& rungs, const std::vector<Rung>& cases, const Options& options) {
  const bool exact = options.reference.empty() && std::ranges::all_of(cases, [](const Rung& rung) {
                       return !rung.scene || !why_not_exact(*rung.scene);
                     });
  fs::path reference = options.reference;
  if (!exact && reference.empty()) {
    const auto finest =
        std::ranges::max_element(rungs, {}, [](const CostRung& rung) { return rung.point.work; });
    reference = options.out / finest->folder;
  }
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    CostRung& rung = rungs[i];
    if (!cases[i].scene)
      continue;
    const fs::path folder = options.out / rung.folder;
    rung.reference = !exact && fs::equivalent(folder, reference);
    if (rung.reference)
      continue;
    const results::RunReader run(folder / "run.h5");
    const RunError error = exact ? error_to_exact(run, *cases[i].scene)
                                 : error_to_run(run, results::RunReader(reference / "run.h5"));
    rung.point.error = error.relative_l2;
    rung.phase_lag = error.phase_lag;
  }
  if (exact)
    return "particle velocity against the exact field, relative L2 over all particles and frames";
  return fmt::format(
      "velocity at the monitors against the run {}, which has an error of its own, relative L2",
      reference.filename().string());
}

/// The family whose fit reaches the target in the least time.
std::optional<CostPrediction> predict(const scene::Case& given, const CostStudy& study) {
  if (std::ranges::find(study.knobs, size_key, &Knob::key) == study.knobs.end())
    return std::nullopt;
  std::optional<CostPrediction> best;
  for (const CostFit& fit : fits(study.points())) {
    const auto wanted = size_for(fit, *study.target);
    if (!wanted)
      continue;
    const auto member =
        std::ranges::find(study.rungs, fit.family, [](const CostRung& rung) { return rung.point.family; });
    const auto size = admissible_size(given, study.knobs, member->values, *wanted);
    if (size && (!best || fit.cpu_at(*size) < best->fit.cpu_at(best->size)))
      best = {fit, *size};
  }
  return best;
}

void study_cost(const Options& options) {
  const auto given = scene::load(options.case_file);
  const auto target = options.target ? std::optional(target_from(*options.target)) : std::nullopt;
  std::vector<Knob> knobs;
  for (const std::string& text : options.knobs)
    knobs.push_back(knob_from(text));
  if (knobs.empty())
    knobs = default_knobs(given);
  const auto cases = ladder(given, knobs);
  require_rungs(cases, knobs);
  make_folder(options.out);
  require_writable_in(options.out,
                      {{"cost.json", has_words("\"error_of\": ")},
                       {"cost.csv", has_words(cost_columns)},
                       {"cost.png", is_picture_of_tremolo}},
                      {options.case_file});

  CostStudy study{.title = given.title,
                  .error_of = {},
                  .knobs = knobs,
                  .rungs = run_ladder(cases, knobs, options),
                  .target = target,
                  .prediction = {}};
  study.error_of = measure(study.rungs, cases, options);
  if (target)
    study.prediction = predict(given, study);
  fmt::print("\n{}", cost_text(study));
  write_cost(study, options.out);
  if (run_python("cost-picture", {options.out.string()}) != 0)
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
