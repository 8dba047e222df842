// sweep.json and the cases of a sweep, as the Python package reads them.

#include "app/output_place.hpp"
#include "app/sweep/sweep_plan.hpp"
#include "base/text/text_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <toml++/toml.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace tremolo::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Numbers that the runs of earlier plans have, by the text of their cases.
std::map<std::string, std::string> known_names(const fs::path& cases) {
  std::map<std::string, std::string> names;
  for (const auto& entry : fs::directory_iterator(cases))
    if (entry.path().extension() == ".toml" && entry.path().stem().extension().empty())
      names[read_text_file(entry.path())] = entry.path().stem().string();
  return names;
}

/// "0001", the next one that no run of an earlier plan has.
std::string next_name(const fs::path& cases, std::size_t& number) {
  std::string name;
  do
    name = fmt::format("{:04}", ++number);
  while (fs::exists(cases / (name + ".toml")));
  return name;
}

/// Name of a file without folder and extension.
std::string stem(const std::string& toml) {
  const toml::table table = toml::parse(fmt::format("value = {}", toml));
  return fs::path(table["value"].value_or(std::string())).stem().string();
}

/// A value as JSON; of a file, its name without folder and extension where the others have another one.
Json shown(const scene::Axis& axis, const scene::AxisValue& value) {
  if (value.toml != value.shown) {
    const std::string name = stem(value.toml);
    if (std::ranges::count_if(axis.values, [&](const auto& other) { return stem(other.toml) == name; }) == 1)
      return name;
  }
  std::ostringstream json;
  const toml::table table = toml::parse(fmt::format("value = {}", value.shown));
  json << toml::json_formatter{table};
  return Json::parse(json.str()).at("value");
}

Json measures(const std::optional<motion::Measures>& of) {
  if (!of)
    return nullptr;
  return {{"pga", of->pga},
          {"pgv", of->pgv},
          {"arias", of->arias},
          {"significant_duration", of->significant_duration},
          {"mean_period", of->mean_period}};
}

/// The axes of the study, and as the last one the models of its site responses.
Json axes_json(const scene::Study& study, const std::vector<scene::Axis>& axes) {
  Json all = Json::array();
  for (const scene::Axis& axis : axes)
    all.push_back({{"key", axis.key}, {"unit", axis.unit}, {"values", axis.range ? 0 : axis.values.size()}});
  if (!study.models.empty())
    all.push_back({{"key", scene::model_key}, {"unit", ""}, {"values", study.models.size()}});
  return all;
}

Json settings(const scene::Study& study) {
  Json json = {{"failure_strain", study.failure_strain},
               {"intensity", scene::name(study.intensity)},
               {"colour", study.colour},
               {"draw", study.draw},
               {"spectral_ratio", nullptr}};
  if (const auto& ratio = study.spectral_ratio)
    json["spectral_ratio"] = {{"of", ratio->of}, {"over", ratio->over}, {"periods", ratio->periods}};
  return json;
}

} // namespace

void write_plan(const scene::Study& study, const std::vector<scene::Axis>& axes, const scene::Case& given,
                const std::vector<SweepRun>& runs, const fs::path& folder) {
  const fs::path cases = folder / "cases";
  make_folder(cases);
  auto names = known_names(cases);
  std::map<std::string, std::size_t> groups;
  std::size_t number = 0;
  Json all = Json::array();
  for (const SweepRun& run : runs) {
    auto& name = names[run.text];
    if (name.empty()) {
      name = next_name(cases, number);
      write_text_file(cases / (name + ".toml"), run.text);
    }
    if (!run.model)
      write_text_file(cases / (name + ".recorded.toml"), run.recording_text);
    Json values = Json::array();
    for (std::size_t a = 0; a < axes.size(); ++a)
      values.push_back(shown(axes[a], run.values[a]));
    if (run.model)
      values.push_back(Json(scene::name(*run.model)));
    all.push_back(
        {{"name", name},
         {"values", values},
         {"model", run.model ? Json(scene::name(*run.model)) : Json(nullptr)},
         {"inputs", run.inputs},
         {"free_fields", run.free_fields.empty()
                             ? Json(nullptr)
                             : Json(groups.try_emplace(run.free_fields, groups.size()).first->second)},
         {"motion", measures(run.motion)}});
  }
  const Json plan = {{"title", study.title.empty() ? given.title : study.title},
                     {"study", fs::absolute(study.file).string()},
                     {"case", fs::absolute(study.case_file).string()},
                     {"design", scene::name(study.design)},
                     {"keeps_recordings", given.recording.exchange},
                     {"axes", axes_json(study, axes)},
                     {"measures", settings(study)},
                     {"runs", all}};
  write_text_file(folder / "sweep.json", plan.dump(1) + "\n");
}

} // namespace tremolo::app
