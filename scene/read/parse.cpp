#include "scene/case.hpp"

#include "scene/ground.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/read/read.hpp"
#include "scene/read/soil/slice_soils.hpp"
#include "scene/rules/rule.hpp"
#include "scene/text/text.hpp"

#include <fmt/format.h>

#include <vector>

namespace tremolo::scene {

namespace {

/// Whether the record that [motion] names must be there.
enum class CaseRecord { needed, to_be_made };

/// What carries the model, on which tables depend that are read before [boundary].
void read_base_model(const toml::table& root, Case& scene) {
  const auto word = root.at_path("boundary.base.model").value<std::string_view>();
  if (const auto model = value_named<SourceModel>(word.value_or("")))
    scene.boundary.base.field.model = *model;
}

/// [boundary.left] and [boundary.right], of which one is asked for.
void read_sides(Document& document, Side asked, Findings& findings, Case& scene) {
  read_boundary(document, findings, scene);
  if (!scene.boundary.has_lateral_fields())
    findings.add("boundary", fmt::format("the {} side is asked for, but sides = \"{}\" have no free field",
                                         name(asked), name(scene.boundary.sides)));
}

/// The text of a case, and what its messages and relative names start from.
struct CaseText {
  std::string_view text;
  const std::filesystem::path& file;
  const std::filesystem::path& directory;
};

Case read_ground(const CaseText& given, SourceModel model, CaseRecord record, std::optional<Side> side) {
  Findings findings(given.file.string());
  Case scene;
  scene.file = given.file;
  scene.directory = given.directory;
  scene.text = given.text;

  const toml::table root = parse_toml(scene.text, findings);
  DepthProfiles profiles;
  Document document(root, {case_keys(), findings, scene.values, &profiles});
  if (document.has("mesh")) {
    read_mesh(document, scene);
    read_time(document, findings, scene);
  }
  if (document.has("stage"))
    read_stages(document, findings, scene);
  read_free_field(document, findings, scene);
  auto& [sides, left, right, base] = scene.boundary;
  left.surface = right.surface = scene.surface_level;
  if (scene.water)
    left.water_level = right.water_level = scene.water->beside(Side::left, scene.surface_level);
  if (side)
    read_sides(document, *side, findings, scene);
  left.field.model = right.field.model = base.field.model = model;
  slice_soils(root, profiles, findings, scene);
  std::vector known = {Needs::ground};
  if (traits(model).effective_stress) // other models know grains and water together
    known.push_back(Needs::effective_stress);
  if (record == CaseRecord::needed)
    known.push_back(Needs::record);
  judge(scene, findings, known);
  scene.remarks = findings.remarks();
  return scene;
}

} // namespace

Case parse(std::string_view text, const std::filesystem::path& file, const std::filesystem::path& directory) {
  Findings findings(file.string());
  Case scene;
  scene.file = file;
  scene.directory = directory;
  scene.text = text;

  const toml::table root = parse_toml(text, findings);
  DepthProfiles profiles;
  Document document(root, {case_keys(), findings, scene.values, &profiles});
  scene.title = document.table("").text("title");
  read_mesh(document, scene);
  if (!document.has("soil"))
    document.named("soil"); // reports that there is none
  read_base_model(root, scene);
  read_stages(document, findings, scene);
  read_free_field(document, findings, scene);
  read_boundary(document, findings, scene);
  read_model(document, findings, scene);
  read_run(document, findings, scene);
  read_hosts(document, scene);
  slice_soils(root, profiles, findings, scene);
  find_standing(scene, findings);
  judge(scene, findings);
  scene.remarks = findings.remarks();
  return scene;
}

Case load(const std::filesystem::path& file) {
  return parse(read_text(file), file, file.parent_path());
}

Case load_free_field(const std::filesystem::path& file, SourceModel model) {
  return parse_free_field(read_text(file), file, file.parent_path(), model);
}

Case parse_free_field(std::string_view text, const std::filesystem::path& file,
                      const std::filesystem::path& directory, SourceModel model) {
  return read_ground({text, file, directory}, model, CaseRecord::needed, std::nullopt);
}

Case load_ground(const std::filesystem::path& file, SourceModel model, std::optional<Side> side) {
  return read_ground({read_text(file), file, file.parent_path()}, model, CaseRecord::to_be_made, side);
}

} // namespace tremolo::scene
