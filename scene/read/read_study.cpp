#include "base/text/unreadable.hpp"
#include "scene/keys/keys_study.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/read/reader.hpp"
#include "scene/soils/soil_library.hpp"
#include "scene/study.hpp"
#include "scene/text/nearest.hpp"
#include "scene/text/set_value.hpp"
#include "scene/text/text.hpp"
#include "scene/text/text_edit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace tremolo::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view axes_table = "axes";
constexpr std::string_view angle_key = "motion.angle_deg";

Place axis_place(const toml::source_region& source) {
  return {source.begin.line, source.begin.column, std::string(axes_table)};
}

/// Whether a key of a case names a file.
bool names_file(std::string_view key) {
  return key == record_key ||
         (key.starts_with("boundary.") && (key.ends_with(".file") || key.ends_with(".program"))) ||
         (key.starts_with("soil.") && key.ends_with(".curve"));
}

/// The key table of a case's table: "soil" for "soil.sand", "region" for "region[0]"; none where no case has
/// it.
const Table* table_of(std::string_view path) {
  const std::string plain(path.substr(0, path.find('[')));
  for (const Table& table : case_keys()) {
    if (table.name == plain)
      return &table;
    if (table.kind == Kind::named && plain.starts_with(std::string(table.name) + "."))
      return &table;
  }
  return nullptr;
}

std::string unit_of(std::string_view key) {
  const auto dot = key.rfind('.');
  const Table* table = table_of(dot == std::string_view::npos ? "" : key.substr(0, dot));
  const Key* known =
      table != nullptr ? table->find(key.substr(dot == std::string_view::npos ? 0 : dot + 1)) : nullptr;
  return known == nullptr || known->unit == "1" ? "" : std::string(known->unit);
}

/// Reads the axes out of the tables of [axes].
class AxesReader {
public:
  AxesReader(std::string_view text, const fs::path& directory, SweepDesign design, Reading reading)
      : text_(text), directory_(directory), design_(design), reading_(reading) {}

  void read(const toml::table& table, const std::string& prefix) {
    // toml++ sorts keys by name; axes keep the order of the file.
    std::vector<std::pair<const toml::key*, const toml::node*>> pairs;
    for (auto&& [name, node] : table)
      pairs.emplace_back(&name, &node);
    std::ranges::stable_sort(pairs, {}, [](const auto& pair) {
      const auto begin = pair.first->source().begin;
      return std::pair(begin.line, begin.column);
    });
    for (const auto& [name, node] : pairs)
      read_node(prefix + std::string(name->str()), *name, *node);
  }

  std::vector<Axis> axes() && { return std::move(axes_); }

private:
  void refuse(const Axis& axis, std::string why) {
    reading_.findings.add("axes." + axis.key, axis.place, fmt::format("'{}' {}", axis.key, why));
  }

  void read_node(const std::string& key, const toml::key& name, const toml::node& node) {
    Axis axis{.key = key, .unit = unit_of(key), .place = axis_place(name.source())};
    if (const auto* table = node.as_table()) {
      if (is_range(*table))
        read_range(std::move(axis), *table);
      else if (table->contains("count"))
        read_count(std::move(axis), *table);
      else
        read(*table, key + ".");
    } else if (const auto* array = node.as_array()) {
      read_values(std::move(axis), *array);
    } else {
      refuse(axis, fmt::format("must be an array of its values, found {0}: write {1} = [{2}]",
                               type_name(node), key, slice(node)));
    }
  }

  static bool is_range(const toml::table& table) { return table.contains("low") || table.contains("high"); }

  std::string slice(const toml::node& node) const {
    const auto begin = offset(text_, node.source().begin);
    return std::string(text_.substr(begin, offset(text_, node.source().end) - begin));
  }

  AxisValue value(const std::string& key, const toml::node& node) const {
    AxisValue value{slice(node), slice(node), axis_place(node.source())};
    if (const auto* name = node.as_string();
        name != nullptr && names_file(key) && name->get() != built_in_curve)
      value.toml = toml_value(fs::absolute(directory_ / name->get()).lexically_normal().string());
    return value;
  }

  void read_values(Axis axis, const toml::array& array) {
    if (array.empty())
      return refuse(axis, "has no value: an axis needs one at least");
    for (const toml::node& node : array) {
      AxisValue next = value(axis.key, node);
      if (std::ranges::count(axis.values, next.toml, &AxisValue::toml) > 0)
        reading_.findings.add("axes." + axis.key, next.place,
                              fmt::format("'{}' has the value {} twice", axis.key, next.shown));
      axis.values.push_back(std::move(next));
    }
    axes_.push_back(std::move(axis));
  }

  void read_count(Axis axis, const toml::table& table) {
    const std::string path = "axes." + axis.key;
    reading_.findings.locate(path, axis.place);
    const TableReader count(count_keys(), &table, path, std::string(axes_table), reading_);
    for (int number = 1; number <= count.integer("count"); ++number)
      axis.values.push_back({std::to_string(number), std::to_string(number), axis.place});
    axes_.push_back(std::move(axis));
  }

  void read_range(Axis axis, const toml::table& table) {
    const std::string path = "axes." + axis.key;
    reading_.findings.locate(path, axis.place);
    const TableReader range(range_keys(), &table, path, std::string(axes_table), reading_);
    if (design_ != SweepDesign::latin_hypercube)
      return refuse(axis,
                    "has a range, which only [design] kind = \"latin_hypercube\" takes: write an array");
    axis.range = {range.number("low"), range.number("high"), range.choice<RangeScale>("scale")};
    if (!(axis.range->low < axis.range->high))
      refuse(axis, fmt::format("has 'low' = {} not below 'high' = {}", axis.range->low, axis.range->high));
    else if (axis.range->scale == RangeScale::log && !(axis.range->low > 0.0))
      refuse(axis, fmt::format("has 'low' = {}; on a logarithmic scale it must be > 0", axis.range->low));
    axes_.push_back(std::move(axis));
  }

  std::string_view text_;
  fs::path directory_;
  SweepDesign design_;
  Reading reading_;
  std::vector<Axis> axes_;
};

/// @param name  as the study writes it; empty where it has been refused already
void require_readable(const std::string& name, const std::string& path, const fs::path& file,
                      Findings& findings) {
  if (const auto why = why_unreadable(file); !name.empty() && !why.empty())
    findings.add(path, fmt::format("{}: {}", file.string(), why));
}

void check_list(const Study& study, Findings& findings) {
  std::size_t length = study.motions ? static_cast<std::size_t>(study.motions->count) : 0;
  std::string longest = "count of [motions]";
  for (const Axis& axis : study.axes)
    if (axis.values.size() > 1 && length <= 1) {
      length = axis.values.size();
      longest = fmt::format("'{}'", axis.key);
    }
  for (const Axis& axis : study.axes)
    if (axis.values.size() > 1 && axis.values.size() != length)
      findings.add("axes." + axis.key, axis.place,
                   fmt::format("'{}' has {} values, {} has {}: in a list they go together, one by one",
                               axis.key, axis.values.size(), longest, length));
}

/// The axis whose values differ by colour.
std::string colour_of(const Study& study, const TableReader& measures, Findings& findings) {
  const auto compared = [&](std::string_view key) {
    return (key == model_key && study.models.size() > 1) ||
           std::ranges::any_of(study.axes,
                               [&](const Axis& axis) { return axis.key == key && axis.values.size() > 1; });
  };
  if (std::string asked = measures.text("colour"); !asked.empty()) {
    std::vector<std::string_view> keys;
    for (const Axis& axis : study.axes)
      keys.push_back(axis.key);
    if (!study.models.empty())
      keys.push_back(model_key);
    if (std::ranges::find(keys, asked) == keys.end())
      findings.add(measures.path("colour"), fmt::format("no axis '{}', {}", asked, suggestion(asked, keys)));
    else if (!compared(asked))
      findings.add(measures.path("colour"),
                   fmt::format("'{}' has no array of several values to distinguish", asked));
    return asked;
  }
  for (const std::string_view key : {model_key, angle_key})
    if (compared(key))
      return std::string(key);
  for (const Axis& axis : study.axes)
    if (axis.key != record_key && axis.key != realisation_key && compared(axis.key))
      return axis.key;
  return "";
}

void read_motions(Document& document, const fs::path& directory, Findings& findings, Study& study) {
  const auto table = document.table("motions");
  if (!document.has("motions"))
    return;
  const std::string recipe = table.text("recipe");
  study.motions = {directory / recipe, table.integer("count"), findings.place(table.path("recipe"))};
  require_readable(recipe, table.path("recipe"), study.motions->recipe, findings);
  for (const Axis& axis : study.axes)
    if (axis.key == record_key)
      findings.add("axes.motion.file", axis.place,
                   "[motions] gives the values of 'motion.file': remove one of the two");
}

/// The models of site responses.
void read_column(Document& document, Study& study) {
  if (!document.has("column"))
    return;
  for (const std::string& word : document.table("column").texts("models"))
    study.models.push_back(computed_model(word));
}

/// Refuses measures of a domain where there is none.
void refuse_domain_measures(const Document& document, const TableReader& measures, Findings& findings) {
  constexpr std::string_view why = "belongs to runs of a domain, and those of [column] have none; remove it";
  if (measures.given("failure_strain"))
    findings.add(measures.path("failure_strain"), fmt::format("'failure_strain' {}", why));
  if (document.has("measures.spectral_ratio"))
    findings.add("measures.spectral_ratio", fmt::format("[measures.spectral_ratio] {}", why));
}

void read_measures(Document& document, Findings& findings, Study& study) {
  const auto measures = document.table("measures");
  study.failure_strain = measures.number("failure_strain");
  study.intensity = measures.choice<Intensity>("intensity");
  study.colour = colour_of(study, measures, findings);
  study.draw = measures.texts("draw");
  const auto ratio = document.table("measures.spectral_ratio");
  if (document.has("measures.spectral_ratio"))
    study.spectral_ratio = {ratio.text("of"), ratio.text("over"), ratio.numbers("periods"),
                            findings.place(ratio.path("of")), findings.place(ratio.path("over"))};
  if (!study.models.empty())
    refuse_domain_measures(document, measures, findings);
}

} // namespace

Study load_study(const fs::path& file) {
  const std::string text = read_text(file);
  Findings findings(file.string());
  std::vector<ValueInForce> values;
  const toml::table root = parse_toml(text, findings);
  const Reading reading{study_keys(), findings, values};
  Document document(root, reading);
  const auto directory = file.parent_path();
  Study study;
  study.file = file;
  const auto top = document.table("");
  study.title = top.text("title");
  study.case_file = directory / top.text("case");
  require_readable(top.text("case"), top.path("case"), study.case_file, findings);
  read_column(document, study);

  const auto design = document.table("design");
  study.design = design.choice<SweepDesign>("kind");
  if (study.design == SweepDesign::latin_hypercube) {
    study.samples = design.integer("samples");
    study.seed = static_cast<std::uint32_t>(design.number("seed"));
  }
  const toml::node* axes = root.get(axes_table);
  if (axes != nullptr && !axes->is_table())
    findings.add("axes", axis_place(axes->source()),
                 "'axes' must be a table of keys of the case and their values");
  if (axes != nullptr && axes->is_table()) {
    AxesReader reader(text, directory, study.design, reading);
    reader.read(*axes->as_table(), "");
    study.axes = std::move(reader).axes();
  }
  read_motions(document, directory, findings, study);
  if (study.axes.empty() && !study.motions && findings.sound("axes") && axes == nullptr)
    findings.add("", Place{1, 1, ""}, "missing table [axes]: keys of the case and their values");
  else if (axes != nullptr && axes->is_table() && axes->as_table()->empty() && !study.motions)
    findings.add("axes", axis_place(axes->source()), "is empty: it names keys of the case and their values");
  read_measures(document, findings, study);
  if (study.design == SweepDesign::list)
    check_list(study, findings);
  findings.throw_if_any();
  return study;
}

} // namespace tremolo::scene
