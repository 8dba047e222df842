#include "app/cost/cost_report.hpp"
#include "base/text_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace tremolo::app {

namespace {

std::string percent(double value) {
  return fmt::format("{:.3g} %", 100.0 * value);
}

std::string column_heads(const CostStudy& study, const std::vector<std::size_t>& widths) {
  std::string text;
  for (std::size_t k = 0; k < study.knobs.size(); ++k)
    text += fmt::format("{:<{}}", study.knobs[k].key, widths[k]);
  return text + fmt::format("{:>11}{:>11}{:>12}{:>12}\n", "error", "lag", "CPU time", "updates");
}

std::string rung_line(const CostRung& rung, const std::vector<std::size_t>& widths) {
  std::string text;
  for (std::size_t k = 0; k < widths.size(); ++k)
    text += fmt::format("{:<{}}", rung.variant.values[k].shown, widths[k]);
  if (!rung.variant.scene)
    return text + fmt::format("  refused: {}\n", rung.variant.refused);
  const std::string error = rung.reference ? "reference" : percent(rung.point.error);
  const std::string lag = rung.phase_lag == 0.0 ? "-" : fmt::format("{:.3f} ms", 1000.0 * rung.phase_lag);
  return text + fmt::format("{:>11}{:>11}{:>10.2f} s{:>12.3g}{}\n", error, lag, rung.point.cpu,
                            rung.point.work, rung.front ? "  *" : "");
}

std::string fit_text(const CostFit& fit) {
  const auto within = [&](double spread) {
    return fit.points > 2 ? fmt::format("within {:.2g} %", 100.0 * (spread - 1.0))
                          : std::string("two points, unchecked");
  };
  return fmt::format("  {}: error {} (h/{:g} m)^{:.2f} ({}), CPU time {:.2g} s + {:.3g} ns an update ({})\n",
                     fit.family.empty() ? "all" : fit.family, percent(fit.error_at(fit.smallest)),
                     fit.smallest, fit.order, within(fit.error_spread), fit.start, 1e9 * fit.per_update,
                     within(fit.time_spread));
}

/// A text on the cheapest way to reach the target.
std::string answer(const CostStudy& study) {
  std::string text;
  const auto points = study.points();
  if (const auto i = cheapest(points, *study.target)) {
    const CostPoint& point = points[*i];
    text += fmt::format("measured: {} with {}mesh.size = {:g}: error {}, {:.3g} s of CPU time\n",
                        percent(*study.target), point.family.empty() ? "" : point.family + ", ", point.size,
                        percent(point.error), point.cpu);
  } else {
    text += fmt::format("measured: no rung reaches {}\n", percent(*study.target));
  }
  if (!study.prediction)
    return text + "predicted: nothing, no fit of these rungs reaches so far\n";
  const auto& [fit, size] = *study.prediction;
  return text +
         fmt::format(
             "predicted: {} with {}mesh.size = {:.6g}: error {}, {:.3g} s of CPU time; not run, by the fit\n",
             percent(*study.target), fit.family.empty() ? "" : fit.family + ", ", size,
             percent(fit.error_at(size)), fit.cpu_at(size));
}

nlohmann::ordered_json to_json(const CostFit& fit) {
  return {
      {"family", fit.family},          {"points", fit.points},           {"order", fit.order},
      {"constant", fit.constant},      {"work_order", fit.work_order},   {"work", fit.work},
      {"start_s", fit.start},          {"per_update_s", fit.per_update}, {"error_spread", fit.error_spread},
      {"time_spread", fit.time_spread}};
}

nlohmann::ordered_json to_json(const CostStudy& study) {
  nlohmann::ordered_json json = {{"title", study.title}, {"error_of", study.error_of}};
  for (const CostRung& rung : study.rungs) {
    nlohmann::ordered_json entry = {{"folder", rung.variant.name}};
    for (std::size_t k = 0; k < study.knobs.size(); ++k)
      entry["knobs"][study.knobs[k].key] = rung.variant.values[k].shown;
    if (!rung.variant.scene) {
      entry["refused"] = rung.variant.refused;
    } else {
      entry["family"] = rung.point.family;
      entry["size"] = rung.point.size;
      if (rung.reference)
        entry["reference"] = true;
      else
        entry["error"] = rung.point.error;
      entry["phase_lag_s"] = rung.phase_lag;
      entry["cpu_s"] = rung.point.cpu;
      entry["updates"] = rung.point.work;
      entry["front"] = rung.front;
    }
    json["rungs"].push_back(std::move(entry));
  }
  json["fits"] = nlohmann::ordered_json::array();
  for (const CostFit& fit : study.fits)
    json["fits"].push_back(to_json(fit));
  if (study.target)
    json["target"] = *study.target;
  if (study.prediction)
    json["prediction"] = {{"family", study.prediction->fit.family},
                          {"size", study.prediction->size},
                          {"error", study.prediction->fit.error_at(study.prediction->size)},
                          {"cpu_s", study.prediction->fit.cpu_at(study.prediction->size)}};
  return json;
}

std::string quoted(const std::string& value) {
  if (value.find_first_of(",\"") == std::string::npos)
    return value;
  std::string text = "\"";
  for (const char c : value)
    text += c == '"' ? "\"\"" : std::string(1, c);
  return text + '"';
}

std::string to_csv(const CostStudy& study) {
  std::string text;
  for (const scene::Axis& knob : study.knobs)
    text += knob.key + ",";
  text += fmt::format("{}\n", cost_columns);
  for (const CostRung& rung : study.rungs) {
    if (!rung.variant.scene)
      continue;
    for (const scene::AxisValue& value : rung.variant.values)
      text += quoted(value.shown) + ",";
    text += fmt::format("{},{},{},{},{}\n", rung.reference ? 0.0 : rung.point.error, rung.phase_lag,
                        rung.point.cpu, rung.point.work, rung.front ? 1 : 0);
  }
  return text;
}

} // namespace

std::vector<CostPoint> CostStudy::points() const {
  std::vector<CostPoint> all;
  for (const CostRung& rung : rungs)
    if (rung.measured())
      all.push_back(rung.point);
  return all;
}

std::string cost_text(const CostStudy& study) {
  std::vector<std::size_t> widths;
  for (std::size_t k = 0; k < study.knobs.size(); ++k) {
    std::size_t width = study.knobs[k].key.size();
    for (const CostRung& rung : study.rungs)
      width = std::max(width, rung.variant.values[k].shown.size());
    widths.push_back(width + 2);
  }
  std::string text = study.title + "\n" + column_heads(study, widths);
  for (const CostRung& rung : study.rungs)
    text += rung_line(rung, widths);
  text += fmt::format("error: {}; CPU time: user and system, of all processes; *: on the Pareto front\n",
                      study.error_of);
  if (!study.fits.empty())
    text += "fits along mesh.size:\n";
  for (const CostFit& fit : study.fits)
    text += fit_text(fit);
  return study.target ? text + answer(study) : text;
}

void write_cost(const CostStudy& study, const std::filesystem::path& folder) {
  write_text_file(folder / "cost.json", to_json(study).dump(2) + "\n");
  write_text_file(folder / "cost.csv", to_csv(study));
}

} // namespace tremolo::app
