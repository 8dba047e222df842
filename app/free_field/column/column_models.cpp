#include "app/free_field/column/column_models.hpp"

#include "base/text/text_file.hpp"
#include "motion/record.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/text/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string_view>

namespace tremolo::app {

namespace {

std::string file_name(scene::SourceModel model) {
  return fmt::format("{}.h5", scene::name(model));
}

/// A text on a model's treatment of soil that yields.
std::string_view soil_of(scene::SourceModel model) {
  switch (scene::traits(model).soil) {
  case scene::SoilTreatment::linear:
    return "linear";
  case scene::SoilTreatment::equivalent_linear:
    return "equivalent linear";
  case scene::SoilTreatment::by_law:
    return "as its law says";
  }
  return {};
}

std::string json_of(const std::string& title, const std::vector<ModelOfSite>& models) {
  nlohmann::ordered_json json = {{"content", "site response"}, {"title", title}};
  json["models"] = nlohmann::ordered_json::array();
  for (const ModelOfSite& one : models) {
    nlohmann::ordered_json entry = {
        {"model", scene::name(one.model)}, {"soil", soil_of(one.model)}, {"refused", one.refused}};
    if (one.refused.empty())
      entry["file"] = file_name(one.model);
    json["models"].push_back(std::move(entry));
  }
  return json.dump(2) + "\n";
}

} // namespace

std::vector<ModelOfSite> column_models(const std::vector<scene::SourceModel>& models,
                                       const std::function<ColumnGround(scene::SourceModel)>& ground_of,
                                       const ColumnHistories& histories,
                                       const std::filesystem::path& folder) {
  std::vector<ModelOfSite> found;
  std::string title;
  for (const scene::SourceModel model : models) {
    ModelOfSite& one = found.emplace_back(ModelOfSite{.model = model, .refused = {}, .summary = {}});
    std::filesystem::remove(folder / file_name(model)); // of an earlier command
    try {
      const ColumnGround ground = ground_of(model);
      title = ground.scene.title;
      one.summary = write_column(ground, histories, folder / file_name(model));
    } catch (const scene::CaseErrors& errors) {
      one.refused = errors.errors().front().message();
    } catch (const std::exception& error) {
      one.refused = error.what();
    }
  }
  write_text_file(folder / "site.json", json_of(title, found));
  return found;
}

std::string models_text(const std::vector<ModelOfSite>& models) {
  std::string text = fmt::format("{:<8}{:<18}{:>14}{:>14}{:>18}{:>12}{:>10}\n", "model", "soil",
                                 "surface PGA", "base PGA", "largest strain", "depth", "CPU");
  for (const auto& [model, refused, found] : models) {
    text += fmt::format("{:<8}{:<18}", scene::name(model), soil_of(model));
    if (!refused.empty()) {
      text += fmt::format("  refused: {}\n", refused.substr(0, refused.find('\n')));
      continue;
    }
    text += fmt::format("{:>12.3f} g{:>12.3f} g{:>16.3g} %{:>10.4g} m{:>8.2f} s\n",
                        found.surface_acceleration / motion::standard_gravity,
                        found.base_acceleration / motion::standard_gravity, 100.0 * found.largest_strain,
                        found.strain_depth, found.cpu_seconds);
  }
  for (const auto& [model, refused, found] : models)
    for (const std::string& warning : found.warnings)
      text += fmt::format("warning: {}: {}\n", scene::name(model), warning);
  return text;
}

} // namespace tremolo::app
