#include "app/sweep/sweep_plan.hpp"

#include "app/study/variant.hpp"
#include "base/text/text_file.hpp"
#include "coupler/process/recorded_case.hpp"
#include "motion/band_limited.hpp"
#include "scene/plan/layers.hpp"
#include "scene/read/override.hpp"
#include "scene/text/errors.hpp"
#include "scene/text/files.hpp"
#include "scene/text/nearest.hpp"
#include "scene/text/set_value.hpp"
#include "wavefield/incident_motion.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include "coupler/wire/handshake/messages.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <stdexcept>

namespace tremolo::app {

namespace {

namespace fs = std::filesystem;

/// Sets the values of a run in the text of its case; a key that has no place there is refused at its place in
/// the study.
std::string text_of(const std::vector<scene::Axis>& axes, const Combination& values, std::string text,
                    scene::Findings& findings) {
  for (std::size_t a = 0; a < axes.size(); ++a)
    try {
      text = scene::with_value(text, axes[a].key, values[a].toml);
    } catch (const std::invalid_argument& error) {
      findings.add("axes." + axes[a].key, axes[a].place, error.what());
    }
  return text;
}

std::string table_name(const std::string& key) {
  const auto dot = key.rfind('.');
  return dot == std::string::npos ? "" : key.substr(0, dot);
}

/// Refuses axes of a table with a name of its own, or of an array, that the case does not have.
void require_tables(const std::vector<scene::Axis>& axes, const scene::Case& given,
                    scene::Findings& findings) {
  const toml::table root = toml::parse(given.text);
  for (const scene::Axis& axis : axes) {
    const auto dot = axis.key.find('.');
    const std::string first = axis.key.substr(0, axis.key.find('['));
    const auto* named =
        dot == std::string::npos ? nullptr : root.get_as<toml::table>(axis.key.substr(0, dot));
    if (axis.key.starts_with("soil.") && named != nullptr) {
      const std::string soil = axis.key.substr(dot + 1, axis.key.find('.', dot + 1) - dot - 1);
      std::vector<std::string_view> known;
      for (const auto& [name, node] : *named)
        known.push_back(name.str());
      if (!named->contains(soil))
        findings.add("axes." + axis.key, axis.place,
                     fmt::format("'{}': the case has no [soil.{}], {}", axis.key, soil,
                                 scene::suggestion(soil, known)));
    } else if (axis.key.find('[') != std::string::npos &&
               root.at_path(table_name(axis.key)).node() == nullptr) {
      findings.add(
          "axes." + axis.key, axis.place,
          fmt::format(
              "'{}': the case has no {}: it has {} of [[{}]], counted from 0", axis.key, table_name(axis.key),
              root.get_as<toml::array>(first) != nullptr ? root.get_as<toml::array>(first)->size() : 0,
              first));
    }
  }
}

/// The axis whose value stands where a case is wrong; the number of axes where none does.
std::size_t axis_at(const std::vector<scene::Axis>& axes, const std::string& text,
                    const scene::Finding& error) {
  const toml::table root = toml::parse(text);
  std::size_t found = axes.size();
  unsigned column = 0;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const auto* node = root.at_path(axes[a].key).node();
    if (node == nullptr)
      continue;
    const auto& [begin, end, path] = node->source();
    const bool on_its_lines = begin.line <= error.line && error.line <= end.line;
    if (on_its_lines && (found == axes.size() || (begin.column > column && begin.column <= error.column))) {
      found = a;
      column = begin.column;
    }
  }
  for (std::size_t a = 0; a < axes.size() && found == axes.size(); ++a) {
    const auto* table = root.at_path(table_name(axes[a].key)).node();
    if (table != nullptr && table->source().begin.line == error.line)
      found = a;
  }
  return found;
}

/// Reports what is wrong with the case of a run, at the places in the study that it comes from.
/// @return whether every error comes from one axis; the others belong to the combination
bool report(const scene::CaseErrors& errors, const std::vector<scene::Axis>& axes, const Combination& values,
            const std::string& text, scene::Findings& findings) {
  bool all = true;
  for (const scene::Finding& error : errors.errors()) {
    const std::size_t a = axis_at(axes, text, error);
    if (a < axes.size()) {
      if (error.text.starts_with("unknown"))
        findings.add("axes." + axes[a].key, axes[a].place, fmt::format("'{}': {}", axes[a].key, error.text));
      else
        findings.add("axes." + axes[a].key, values[a].place,
                     fmt::format("'{}' = {}: {}", axes[a].key, values[a].shown, error.text));
    } else {
      all = false;
      findings.add("axes", values.empty() ? scene::Place{} : values.front().place,
                   fmt::format("no case with {}: {}", setting(axes, values), error.message()));
    }
  }
  return all;
}

/// Measures of the incident wave from its start to the end (s) of the run, or its own.
std::optional<motion::Measures> incident_measures(const scene::Case& scene, double end) {
  try {
    const auto ground = wavefield::ground_from_case(scene, scene::layers(scene, scene.boundary.left));
    const wavefield::Signal signal = wavefield::incident_signal(scene.motion, ground);
    constexpr double samples_per_period = 8.0; // so that peaks lie on samples
    const double dt = 1.0 / (samples_per_period * signal.highest_frequency);
    const auto count =
        static_cast<std::size_t>(std::ceil((std::min(signal.end, end) - signal.begin) / dt)) + 1;
    std::vector<double> velocity(count);
    for (std::size_t i = 0; i < count; ++i)
      if (const double time = signal.begin + static_cast<double>(i) * dt; time <= signal.end)
        velocity[i] = signal.velocity(time);
    return motion::measures(motion::differentiate(velocity, dt), dt);
  } catch (const std::exception&) { // the run will say why
    return std::nullopt;
  }
}

/// The files of data that a case reads, with their checksums.
std::string inputs_of(const scene::Case& scene) {
  std::string inputs;
  for (const fs::path& file : scene::data_files(scene))
    inputs += fmt::format("{} {}\n", coupler::text_crc(read_text_file(file)), file.string());
  return inputs;
}

/// The runs of a combination: one of the domain, or a site response a model. The first line of their cases
/// keeps apart site responses that differ in their model alone.
std::vector<SweepRun> runs_of(const scene::Study& study, const std::string& text, const Combination& values,
                              const scene::Case& given) {
  if (study.models.empty()) {
    const auto scene = scene::parse(text, given.file, given.directory);
    return {{.values = values,
             .model = {},
             .text = text,
             .recording_text = scene::with_value(text, "record.exchange", "true"),
             .inputs = inputs_of(scene),
             .free_fields = coupler::free_field_identity(scene),
             .motion = incident_measures(scene, scene.end())}};
  }
  std::vector<SweepRun> runs;
  for (const scene::SourceModel model : study.models) {
    const auto scene = scene::parse_free_field(text, given.file, given.directory, model);
    runs.push_back({.values = values,
                    .model = model,
                    .text = fmt::format("# For `tremolo column --model {}`.\n{}", scene::name(model), text),
                    .recording_text = {},
                    .inputs = inputs_of(scene),
                    .free_fields = {},
                    // Until the wave is over; it is the motion of all models.
                    .motion = runs.empty() ? incident_measures(scene, HUGE_VAL) : runs.front().motion});
  }
  return runs;
}

} // namespace

std::vector<SweepRun> planned_runs(const scene::Study& study, const std::vector<scene::Axis>& axes,
                                   const scene::Case& given) {
  scene::Findings findings(study.file.string());
  require_tables(axes, given, findings);
  findings.throw_if_any();
  const std::string base = scene::overridden_text(given, {});
  std::vector<SweepRun> runs;
  for (const Combination& values : combinations(study, axes)) {
    const std::string text = text_of(axes, values, base, findings);
    try {
      std::ranges::move(runs_of(study, text, values, given), std::back_inserter(runs));
    } catch (const scene::CaseErrors& errors) {
      if (!report(errors, axes, values, text, findings))
        break; // the next ones would say the same in other words
    }
  }
  findings.throw_if_any();
  return runs;
}

scene::Case case_of(const scene::Study& study) {
  return study.models.empty() ? scene::load(study.case_file)
                              : scene::load_free_field(study.case_file, study.models.front());
}

void require_monitors(const scene::Study& study, const scene::Case& given) {
  if (!study.spectral_ratio)
    return;
  scene::Findings findings(study.file.string());
  std::vector<std::string_view> known;
  for (const auto& monitor : given.monitors)
    known.push_back(monitor.name);
  const auto& ratio = *study.spectral_ratio;
  for (const auto& [name, place] :
       {std::pair(ratio.of, ratio.of_place), std::pair(ratio.over, ratio.over_place)})
    if (std::ranges::find(known, name) == known.end())
      findings.add("measures.spectral_ratio", place,
                   fmt::format("the case has no monitor '{}', {}", name, scene::suggestion(name, known)));
  findings.throw_if_any();
}

} // namespace tremolo::app
