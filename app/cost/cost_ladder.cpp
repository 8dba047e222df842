#include "app/cost/cost_ladder.hpp"

#include "app/free_field/table_text.hpp"
#include "scene/read/override.hpp"
#include "scene/text/errors.hpp"
#include "scene/text/set_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
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

std::string corner(double x, double y) {
  return fmt::format("[{}, {}]", x, y);
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
      corners += (corners.empty() ? "" : ", ") + corner(x, point.y);
    }
    text = scene::with_value(text, scene.regions[r].path + ".polygon", fmt::format("[{}]", corners));
  }
  return text;
}

std::string rung_text(const scene::Case& given, const std::vector<Knob>& knobs,
                      const std::vector<std::string>& values) {
  std::string text = scene::overridden_text(given, {});
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    if (knobs[k].key == width_key)
      text = with_width(std::move(text), given, values[k]);
    else
      text = scene::with_value(text, knobs[k].key,
                               values[k] == no_value ? std::nullopt
                                                     : std::optional(scene::toml_value(values[k])));
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

} // namespace

Knob knob_from(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    throw std::invalid_argument(
        fmt::format("--knob {}: write it as KEY=VALUE,VALUE, such as mesh.size=1,0.5,0.25", text));
  Knob knob{std::string(trimmed(text.substr(0, equals))), split_values(text.substr(equals + 1))};
  for (const std::string& value : knob.values) {
    if (value.empty())
      throw std::invalid_argument(fmt::format("--knob {}: a value is empty", text));
    if (std::ranges::count(knob.values, value) > 1)
      throw std::invalid_argument(fmt::format("--knob {}: the value {} stands twice", text, value));
  }
  return knob;
}

std::vector<Knob> default_knobs(const scene::Case& scene) {
  const double h = scene.mesh.size;
  constexpr double near_limit = 0.95;
  Knob fraction{"time.fraction", {fmt::format("{}", scene.time.fraction)}};
  if (scene.time.fraction < near_limit)
    fraction.values.push_back(fmt::format("{}", near_limit));
  return {{"time.transfer", {"flip", "apic"}},
          std::move(fraction),
          {size_key, {fmt::format("{}", 4.0 * h), fmt::format("{}", 2.0 * h), fmt::format("{}", h)}}};
}

Rung rung_with(const scene::Case& given, const std::vector<Knob>& knobs, std::vector<std::string> values) {
  Rung rung{.values = std::move(values), .text = {}, .scene = {}, .refused = {}};
  rung.text = rung_text(given, knobs, rung.values);
  try {
    rung.scene = scene::parse(rung.text, given.file, given.directory);
  } catch (const scene::CaseErrors& errors) {
    rung.refused = errors.errors().front().message();
  }
  return rung;
}

std::vector<Rung> ladder(const scene::Case& given, const std::vector<Knob>& knobs) {
  for (const Knob& knob : knobs)
    if (std::ranges::count(knobs, knob.key, &Knob::key) > 1)
      throw std::invalid_argument(fmt::format("--knob {}: named twice", knob.key));
  std::vector<std::vector<std::string>> combinations(1);
  for (const Knob& knob : knobs) {
    std::vector<std::vector<std::string>> longer;
    for (const auto& values : combinations)
      for (const std::string& value : knob.values) {
        longer.push_back(values);
        longer.back().push_back(value);
      }
    combinations = std::move(longer);
  }
  std::vector<Rung> rungs;
  rungs.reserve(combinations.size());
  for (auto& values : combinations)
    rungs.push_back(rung_with(given, knobs, std::move(values)));
  return rungs;
}

std::string setting(const std::vector<Knob>& knobs, const std::vector<std::string>& values,
                    const std::string& but) {
  std::string text;
  for (std::size_t k = 0; k < knobs.size(); ++k)
    if (knobs[k].values.size() > 1 && knobs[k].key != but)
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", knobs[k].key, values[k]);
  return text;
}

std::string folder_name(const std::vector<Knob>& knobs, const std::vector<std::string>& values) {
  constexpr std::size_t longest = 24;
  std::string name;
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    std::string value = values[k];
    const bool plain = std::ranges::all_of(
        value, [](unsigned char c) { return std::isalnum(c) != 0 || c == '.' || c == '-' || c == '_'; });
    if (!plain || value.size() > longest)
      value = fmt::format("{:08x}", hash(value));
    name += fmt::format("{}{}={}", name.empty() ? "" : ",", knobs[k].key, value);
  }
  return name;
}

std::optional<double> admissible_size(const scene::Case& given, const std::vector<Knob>& knobs,
                                      std::vector<std::string> values, double size) {
  const auto place = static_cast<std::size_t>(std::ranges::find(knobs, size_key, &Knob::key) - knobs.begin());
  constexpr int tries = 100;
  const double width = given.mesh.box.width();
  const auto fewest = static_cast<int>(std::ceil(width / size * (1.0 - 1e-9)));
  for (int cells = fewest; cells < fewest + tries; ++cells) {
    const double candidate = width / cells;
    values[place] = fmt::format("{}", candidate);
    if (rung_with(given, knobs, values).refused.empty())
      return candidate;
  }
  return std::nullopt;
}

} // namespace tremolo::app
