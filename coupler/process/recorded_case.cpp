#include "coupler/process/recorded_case.hpp"

#include "base/text/text_file.hpp"
#include "coupler/wire/handshake/messages.hpp"
#include "scene/plan/free_field_traits.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <set>
#include <string_view>

namespace tremolo::coupler {

namespace {

constexpr std::string_view checksum_of_file = "file (CRC-32)";

using Values = std::map<std::string, std::string, std::less<>>;

Values by_key(const std::vector<results::RecordedValue>& values) {
  Values map;
  for (const auto& [key, value] : values)
    map[key] = value;
  return map;
}

std::string value_of(const Values& values, std::string_view key) {
  const auto found = values.find(key);
  return found == values.end() ? "not given" : found->second;
}

std::string unquoted(const std::string& text) {
  return text.size() >= 2 && text.front() == '"' ? text.substr(1, text.size() - 2) : text;
}

/// The side whose surface and layers a source at this side has: at the base those of the left one.
scene::Side ground_side(scene::Side side) {
  return side == scene::Side::base ? scene::Side::left : side;
}

/// "boundary.left." of the key of a side's ground, which is compared as "boundary.SIDE."
std::string ground_prefix(scene::Side side) {
  return fmt::format("boundary.{}.", scene::name(ground_side(side)));
}

std::set<std::string> soils_of_layers(const Values& values) {
  std::set<std::string> soils;
  for (const auto& [key, value] : values)
    if (key.find("profile[") != std::string::npos && key.ends_with("].soil"))
      soils.insert(fmt::format("soil.{}.", unquoted(value)));
  return soils;
}

bool begins_with_any(std::string_view key, const auto& prefixes) {
  return std::ranges::any_of(prefixes, [&](std::string_view prefix) { return key.starts_with(prefix); });
}

/// The values on which the free field of a side depends; keys of the side's own ground without its name.
/// @param model of the recording
Values of_free_field(const Values& values, scene::Side side, const std::string& model) {
  const std::array<std::string, 9> always{"motion.",  "surface.", "halfspace.", "profile[", "random_profile.",
                                          "damping.", "mesh.",    model + ".",  "rest."};
  const auto soils = soils_of_layers(values);
  const std::string ground = ground_prefix(side);
  Values kept;
  for (const auto& [key, value] : values) {
    if (key == "motion.file" || key == "motion.vertical.file")
      continue; // what it holds is compared, not where it lies
    if (begins_with_any(key, always) || begins_with_any(key, soils))
      kept[key] = value;
    else if (key == ground + "surface" || key.starts_with(ground + "profile["))
      kept["boundary.SIDE." + key.substr(ground.size())] = value;
  }
  return kept;
}

std::string shown_key(const std::string& key, scene::Side side) {
  constexpr std::string_view any_side = "boundary.SIDE.";
  return key.starts_with(any_side) ? ground_prefix(side) + key.substr(any_side.size()) : key;
}

/// "motion." and "motion.2.", of the first and the second one.
std::string numbered(std::string_view what, std::size_t index) {
  return index == 0 ? fmt::format("{}.", what) : fmt::format("{}.{}.", what, index + 1);
}

/// Adds the records' contents; for a later shaking all keys of its stage, under a name without the stage's
/// number.
void add_motions(const scene::Case& scene, const scene::MotionInput& input,
                 std::vector<results::RecordedValue>& values) {
  for (std::size_t i = 0; i < input.shakings.size(); ++i) {
    const scene::ShakingMotion& shaking = input.shakings[i];
    const std::string name = numbered(input.path, i);
    if (const auto* file = std::get_if<scene::MotionFile>(&shaking.source))
      values.push_back({name + std::string(checksum_of_file), text_crc(read_text_file(file->path))});
    if (i == 0)
      continue;
    values.push_back({name + "from", fmt::format("{} s", shaking.start)});
    const std::string given = shaking.path + ".";
    for (const scene::ValueInForce& value : scene.values)
      if (value.key.starts_with(given) && value.key != given + "file" &&
          !value.key.starts_with(given + "vertical."))
        values.push_back({name + value.key.substr(given.size()), value.value});
  }
}

void add_rests(const scene::Case& scene, std::vector<results::RecordedValue>& values) {
  std::size_t rests = 0;
  for (const scene::TimedStage& stage : scene.timed)
    if (stage.rest) {
      const std::string name = numbered("rest", rests++);
      values.push_back({name + "from", fmt::format("{} s", stage.start)});
      values.push_back({name + "time_factor", fmt::format("{}", stage.rest->time_factor)});
    }
}

} // namespace

std::vector<results::RecordedValue> recorded_values(const scene::Case& scene) {
  std::vector<results::RecordedValue> values;
  for (const scene::ValueInForce& value : scene.values)
    values.push_back({value.key, value.value});
  for (const scene::MotionInput* wave : scene.plane_waves())
    add_motions(scene, *wave, values);
  add_rests(scene, values);
  return values;
}

std::vector<std::string> free_field_differences(const std::vector<results::RecordedValue>& recording,
                                                scene::Side recorded, const scene::Case& scene,
                                                scene::Side served) {
  const Values all = by_key(recording);
  const std::string model = unquoted(value_of(all, fmt::format("boundary.{}.model", scene::name(recorded))));
  const Values theirs = of_free_field(all, recorded, model);
  const Values ours = of_free_field(by_key(recorded_values(scene)), served, model);
  std::set<std::string> keys;
  for (const Values& values : {theirs, ours})
    for (const auto& [key, value] : values)
      keys.insert(key);
  std::vector<std::string> differences;
  for (const std::string& key : keys)
    if (value_of(theirs, key) != value_of(ours, key))
      differences.push_back(fmt::format("{} is {} in the recording, {} in the case", shown_key(key, served),
                                        value_of(theirs, key), value_of(ours, key)));
  return differences;
}

std::string free_field_identity(const scene::Case& scene) {
  const Values all = by_key(recorded_values(scene));
  std::string identity;
  // Keys in which a recording may differ from the case.
  constexpr std::array beside{"stage", "time.", "water.", "boundary.base.form"};
  for (const auto& [key, value] : all)
    if (begins_with_any(key, beside))
      identity += fmt::format("{} = {}\n", key, value);
  for (const scene::Side side : {scene::Side::left, scene::Side::right, scene::Side::base}) {
    if (!scene.boundary.has_lateral_fields() && side != scene::Side::base)
      continue;
    const std::string model = unquoted(value_of(all, fmt::format("boundary.{}.model", scene::name(side))));
    if (const auto known = value_named<scene::SourceModel>(model);
        known && scene::traits(*known).from_outside)
      return "";
    identity += fmt::format("{} {}\n", scene::name(side), model);
    for (const auto& [key, value] : of_free_field(all, side, model))
      identity += fmt::format("{} = {}\n", key, value);
  }
  return identity;
}

} // namespace tremolo::coupler
