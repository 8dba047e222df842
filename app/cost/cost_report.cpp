#include "app/cost/cost_report.hpp"

#include <nlohmann/json.hpp>

namespace tremolo::app {

namespace {

nlohmann::ordered_json to_json(const CostFit& fit) {
  return {
      {"family", fit.family},          {"points", fit.points},           {"order", fit.order},
      {"constant", fit.constant},      {"work_order", fit.work_order},   {"work", fit.work},
      {"start_s", fit.start},          {"per_update_s", fit.per_update}, {"error_spread", fit.error_spread},
      {"time_spread", fit.time_spread}};
}

} // namespace

std::vector<CostPoint> CostStudy::points() const {
  std::vector<CostPoint> all;
  for (const CostRung& rung : rungs)
    if (rung.measured())
      all.push_back(rung.point);
  return all;
}

std::string cost_json(const CostStudy& study) {
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
  return json.dump(2) + "\n";
}

} // namespace tremolo::app
