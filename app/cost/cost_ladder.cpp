#include "app/cost/cost_ladder.hpp"

#include "app/free_field/table_text.hpp"
#include "scene/read/override.hpp"
#include "scene/text/set_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <stdexcept>

namespace tremolo::app {

namespace {

constexpr std::string_view no_value = "none";

/// The parts between commas that stand outside of brackets, braces and quotes.
std::vector<std::string> split_values(std::string_view text) {
  std::vector<std::string> values(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : text) {
    quoted = quoted != (c == '"');
    if (!quoted)
      depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (c == ',' && depth == 0 && !quoted)
      values.emplace_back();
    else
      values.back() += c;
  }
  for (std::string& value : values)
    value = std::string(trimmed(value));
  return values;
}

/// The case with its sides moved to another distance, m, about the centre.
std::string with_width(std::string text, const scene::Case& scene, const std::string& value) {
  const auto width = finite_number(value);
  if (!width || *width <= 0.0)
    throw std::invalid_argument(fmt::format("{}={}: a width is a positive number, m", width_key, value));
  const scene::Box& box = scene.mesh.box;
  const double left = 0.5 * (box.x_min + box.x_max - *width);
  const double right = left + *width;
  text =
      scene::with_value(text, "mesh.box", fmt::format("[{}, {}, {}, {}]", left, box.y_min, right, box.y_max));
  for (std::size_t r = 0; r < scene.regions.size(); ++r) {
    std::string corners;
    for (const scene::Point& point : scene.regions[r].polygon) {
      const double x = point.x == box.x_min ? left : point.x == box.x_max ? right : point.x;
      corners += fmt::format("{}[{}, {}]", corners.empty() ? "" : ", ", x, point.y);
    }
    text = scene::with_value(text, scene.regions[r].path + ".polygon", fmt::format("[{}]", corners));
  }
  return text;
}

std::string rung_text(const scene::Case& given, const std::vector<scene::Axis>& knobs,
                      const Combination& values) {
  std::string text = scene::overridden_text(given, {});
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    const auto& [toml, shown, place] = values[k];
    text = knobs[k].key == width_key
               ? with_width(std::move(text), given, shown)
               : scene::with_value(text, knobs[k].key, toml.empty() ? std::nullopt : std::optional(toml));
  }
  return text;
}

/// FNV-1a: a short name for a long text.
std::uint32_t hash(std::string_view text) {
  std::uint32_t value = 2166136261U;
  for (const char c : text)
    value = (value ^ static_cast<unsigned char>(c)) * 16777619U;
  return value;
}

/// "mesh.size=0.5,time.transfer=apic"; long values are named by their hash.
std::string folder_name(const std::vector<scene::Axis>& knobs, const Combination& values) {
  constexpr std::size_t longest = 24;
  std::string name;
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    std::string value = values[k].shown;
    const bool plain = std::ranges::all_of(
        value, [](unsigned char c) { return std::isalnum(c) != 0 || c == '.' || c == '-' || c == '_'; });
    if (!plain || value.size() > longest)
      value = fmt::format("{:08x}", hash(value));
    name += fmt::format("{}{}={}", name.empty() ? "" : ",", knobs[k].key, value);
  }
  return name;
}

} // namespace

scene::AxisValue knob_value(const std::string& value) {
  return {value == no_value ? "" : scene::toml_value(value), value};
}

scene::Axis knob(std::string key, const std::vector<std::string>& values) {
  scene::Axis axis{.key = std::move(key)};
  std::ranges::transform(values, std::back_inserter(axis.values), knob_value);
  return axis;
}

scene::Axis knob_from(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    throw std::invalid_argument(
        fmt::format("--knob {}: write it as KEY=VALUE,VALUE, such as mesh.size=1,0.5,0.25", text));
  const auto values = split_values(text.substr(equals + 1));
  for (const std::string& value : values) {
    if (value.empty())
      throw std::invalid_argument(fmt::format("--knob {}: a value is empty", text));
    if (std::ranges::count(values, value) > 1)
      throw std::invalid_argument(fmt::format("--knob {}: the value {} stands twice", text, value));
  }
  return knob(std::string(trimmed(text.substr(0, equals))), values);
}

std::vector<scene::Axis> default_knobs(const scene::Case& scene) {
  constexpr double near_limit = 0.95;
  const auto numbers = [](const char* key, std::initializer_list<double> values) {
    scene::Axis axis{.key = key};
    for (const double value : values)
      axis.values.push_back(knob_value(fmt::format("{}", value)));
    return axis;
  };
  const double h = scene.mesh.size;
  const double fraction = scene.time.fraction;
  return {knob("time.transfer", {"flip", "apic"}),
          fraction < near_limit ? numbers("time.fraction", {fraction, near_limit})
                                : numbers("time.fraction", {fraction}),
          numbers(size_key, {4.0 * h, 2.0 * h, h})};
}

Variant rung(const scene::Case& given, const std::vector<scene::Axis>& knobs, const Combination& values) {
  return variant_of(given, folder_name(knobs, values), rung_text(given, knobs, values), values);
}

std::vector<Variant> ladder(const scene::Case& given, const std::vector<scene::Axis>& knobs) {
  for (const scene::Axis& axis : knobs)
    if (std::ranges::count(knobs, axis.key, &scene::Axis::key) > 1)
      throw std::invalid_argument(fmt::format("--knob {}: named twice", axis.key));
  std::vector<Variant> rungs;
  for (const Combination& values : product(knobs))
    rungs.push_back(rung(given, knobs, values));
  return rungs;
}

std::string family(const std::vector<scene::Axis>& knobs, const Combination& values) {
  return setting(knobs, values,
                 [](const scene::Axis& axis) { return axis.values.size() > 1 && axis.key != size_key; });
}

std::optional<double> admissible_size(const scene::Case& given, const std::vector<scene::Axis>& knobs,
                                      Combination values, double size) {
  const auto place =
      static_cast<std::size_t>(std::ranges::find(knobs, size_key, &scene::Axis::key) - knobs.begin());
  constexpr int tries = 100;
  const double width = given.mesh.box.width();
  const auto fewest = static_cast<int>(std::ceil(width / size * (1.0 - 1e-9)));
  for (int cells = fewest; cells < fewest + tries; ++cells) {
    const double candidate = width / cells;
    values[place] = knob_value(fmt::format("{}", candidate));
    if (rung(given, knobs, values).scene)
      return candidate;
  }
  return std::nullopt;
}

} // namespace tremolo::app
