// Table:  v(z) = v_i + (v_i+1 - v_i) (z - z_i)/(z_i+1 - z_i),  z_i <= z <= z_i+1
// Power:  v = R (sigma'_v / p)^n, the form of Janbu (1963), Soil compressibility as determined by oedometer
//         and triaxial tests, for moduli; n = 1 is a strength of s_u/sigma'_v = R/p

#include "scene/read/soil/depth_profile.hpp"

#include "base/text/unit_text.hpp"
#include "scene/read/reader.hpp"
#include "scene/text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tremolo::scene {

namespace {

using Refuse = std::function<void(const toml::node&, std::string)>;

constexpr std::array<std::string_view, 6> profile_keys = {"depth",     "elevation", "value",
                                                          "reference", "stress",    "exponent"};
constexpr Range stresses = {.low = 0.0, .low_open = true};
constexpr Range exponents = {.low = 0.0, .high = 2.0};

/// Reads the parts of one profile, and remembers whether all of them are right.
class ProfileReader {
public:
  ProfileReader(const Key& key, const toml::table& table, const Refuse& refuse)
      : key_(key), table_(table), refuse_(refuse) {}

  std::optional<DepthProfile> read() {
    for (const auto& [name, node] : table_)
      if (std::ranges::find(profile_keys, name.str()) == profile_keys.end())
        wrong(node, fmt::format("unknown key '{}' in the profile '{}', {}", name.str(), key_.name,
                                suggestion(name.str(), profile_keys)));
    if (!sound_)
      return std::nullopt;
    const bool power = has("reference") || has("stress") || has("exponent");
    const bool by_depth = has("depth");
    if (power == (by_depth || has("elevation") || has("value")) || (by_depth && has("elevation"))) {
      wrong(table_, fmt::format("'{}' over depth must have one of the forms {}", key_.name, profile_forms));
      return std::nullopt;
    }
    return power ? read_power() : read_table(by_depth);
  }

private:
  bool has(std::string_view name) const { return table_.contains(name); }

  void wrong(const toml::node& node, std::string why) {
    refuse_(node, std::move(why));
    sound_ = false;
  }

  double number(const toml::node& node, std::string_view name, const Range& range, std::string_view unit) {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value))
      wrong(node, fmt::format("'{}' of the profile '{}' must be a finite number, found {}", name, key_.name,
                              value ? fmt::to_string(*value) : type_name(node)));
    else if (!range.contains(*value))
      wrong(node, fmt::format("'{}' = {} of the profile '{}' is out of range, must be {}", name, *value,
                              key_.name, with_unit(range.text(), unit)));
    return value.value_or(0.0);
  }

  const toml::node* part(std::string_view name) {
    const toml::node* node = table_.get(name);
    if (node == nullptr)
      wrong(table_, fmt::format("missing '{}' of the profile '{}'; the forms are {}", name, key_.name,
                                profile_forms));
    return node;
  }

  double number(std::string_view name, const Range& range, std::string_view unit) {
    const toml::node* node = part(name);
    return node == nullptr ? 0.0 : number(*node, name, range, unit);
  }

  std::vector<double> numbers(std::string_view name, const Range& range, std::string_view unit) {
    const toml::node* node = part(name);
    if (node == nullptr)
      return {};
    const toml::array* array = node->as_array();
    if (array == nullptr || array->size() < 2) {
      wrong(*node,
            fmt::format("'{}' of the profile '{}' must be an array of at least 2 numbers, found {}", name,
                        key_.name, array == nullptr ? type_name(*node) : fmt::format("{}", array->size())));
      return {};
    }
    std::vector<double> values;
    for (const toml::node& element : *array)
      values.push_back(number(element, name, range, unit));
    return values;
  }

  std::optional<DepthProfile> read_power() {
    const StressPower power{number("reference", key_.range, key_.unit), number("stress", stresses, "Pa"),
                            number("exponent", exponents, "1")};
    return sound_ ? std::optional<DepthProfile>(power) : std::nullopt;
  }

  std::optional<DepthProfile> read_table(bool by_depth) {
    const std::string_view name = by_depth ? "depth" : "elevation";
    const LevelTable table{by_depth, numbers(name, {}, "m"), numbers("value", key_.range, key_.unit)};
    if (!sound_)
      return std::nullopt;
    if (table.levels.size() != table.values.size())
      wrong(*table_.get("value"), fmt::format("'value' of the profile '{}' has {} numbers, '{}' has {}: each "
                                              "level needs one value",
                                              key_.name, table.values.size(), name, table.levels.size()));
    for (std::size_t i = 1; i < table.levels.size(); ++i)
      if (!(table.levels[i] > table.levels[i - 1])) {
        wrong(*table_.get(name)->as_array()->get(i),
              fmt::format("'{}' of the profile '{}' must rise, found {} behind {}", name, key_.name,
                          table.levels[i], table.levels[i - 1]));
        break;
      }
    return sound_ ? std::optional<DepthProfile>(table) : std::nullopt;
  }

  const Key& key_;
  const toml::table& table_;
  const Refuse& refuse_;
  bool sound_ = true;
};

double interpolated(const LevelTable& table, double level) {
  const auto& z = table.levels;
  if (level <= z.front())
    return table.values.front();
  if (level >= z.back())
    return table.values.back();
  const auto i = static_cast<std::size_t>(std::ranges::upper_bound(z, level) - z.begin());
  return std::lerp(table.values[i - 1], table.values[i], (level - z[i - 1]) / (z[i] - z[i - 1]));
}

} // namespace

std::optional<DepthProfile> read_profile(const Key& key, const toml::table& table, const Refuse& refuse) {
  return ProfileReader(key, table, refuse).read();
}

std::optional<double> value_at(const DepthProfile& profile, const SlicePlace& place) {
  if (const auto* table = std::get_if<LevelTable>(&profile))
    return interpolated(*table, table->by_depth ? place.depth : place.y);
  if (!place.stress)
    return std::nullopt;
  const auto& power = std::get<StressPower>(profile);
  return power.reference * std::pow(*place.stress / power.stress, power.exponent);
}

double typical_value(const DepthProfile& profile) {
  if (const auto* table = std::get_if<LevelTable>(&profile))
    return table->values.front();
  return std::get<StressPower>(profile).reference;
}

std::string text(const DepthProfile& profile) {
  if (const auto* table = std::get_if<LevelTable>(&profile))
    return fmt::format("{{ {} = [{}], value = [{}] }}", table->by_depth ? "depth" : "elevation",
                       fmt::join(table->levels, ", "), fmt::join(table->values, ", "));
  const auto& power = std::get<StressPower>(profile);
  return fmt::format("{{ reference = {}, stress = {}, exponent = {} }}", power.reference, power.stress,
                     power.exponent);
}

} // namespace tremolo::scene
