#include "motion/make/recipe.hpp"

#include "base/text/printable.hpp"
#include "base/text/unreadable.hpp"

#include "motion/read/read.hpp"
#include "motion/read/text.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>
#include <set>

namespace tremolo::motion {

namespace {

/// A table whose keys are all accounted for when it has been read.
class Keys {
public:
  Keys(const toml::table& table, std::string shown, const std::filesystem::path& file)
      : table_(table), shown_(std::move(shown)), file_(file) {}

  bool has(const char* key) const { return table_.contains(key); }

  double number(const char* key) {
    const auto value = number_in(node(key));
    if (!value || !std::isfinite(*value))
      refuse(node(key), fmt::format("{} must be a finite number", key));
    return *value;
  }

  double number(const char* key, double otherwise) { return has(key) ? number(key) : otherwise; }

  std::int64_t whole(const char* key, std::int64_t most) {
    const auto value = node(key).value_exact<std::int64_t>();
    if (!value || *value < 0 || *value > most)
      refuse(node(key), fmt::format("{} must be a whole number from 0 to {}", key, most));
    return *value;
  }

  std::int64_t whole(const char* key, std::int64_t most, std::int64_t otherwise) {
    return has(key) ? whole(key, most) : otherwise;
  }

  std::string text(const char* key) {
    const auto value = node(key).value_exact<std::string>();
    if (!value)
      refuse(node(key), fmt::format("{} must be a text", key));
    return *value;
  }

  template <class Enum>
  Enum word(const char* key, std::optional<Enum> (*named)(std::string_view)) {
    const std::string given = text(key);
    const auto value = named(given);
    if (!value)
      refuse(node(key), fmt::format("{} = '{}' is not known", key, shown(given)));
    return *value;
  }

  template <std::size_t n>
  std::array<double, n> numbers(const char* key) {
    const toml::array* array = node(key).as_array();
    std::array<double, n> values{};
    bool sound = array != nullptr && array->size() == n;
    for (std::size_t i = 0; sound && i < n; ++i) {
      const auto value = number_in(*array->get(i));
      sound = value.has_value();
      values[i] = value.value_or(0.0);
    }
    if (!sound)
      refuse(node(key), fmt::format("{} must be {} numbers", key, n));
    return values;
  }

  Keys table(const char* key) {
    const toml::table* inner = node(key).as_table();
    if (inner == nullptr)
      refuse(node(key), fmt::format("{} must be a table", key));
    return {*inner, fmt::format("[{}]", key), file_};
  }

  /// @throws RecordError for an unknown key
  void finish() const {
    for (const auto& [key, node] : table_)
      if (!known_.contains(std::string(key.str())))
        refuse(node, fmt::format("unknown key {} in {}", shown(key.str()), shown_));
  }

private:
  /// The nearest double, also of an integer that none equals, of which toml++ has no value<double>().
  static std::optional<double> number_in(const toml::node& node) {
    if (const auto* integer = node.as_integer())
      return static_cast<double>(integer->get());
    const auto* number = node.as_floating_point();
    return number != nullptr ? std::optional(number->get()) : std::nullopt;
  }

  const toml::node& node(const char* key) {
    known_.insert(key);
    const toml::node* found = table_.get(key);
    if (found == nullptr)
      refuse(table_, fmt::format("{} lacks the key {}", shown_, key));
    return *found;
  }

  [[noreturn]] void refuse(const toml::node& node, const std::string& text) const {
    motion::refuse(file_, node.source().begin.line, text);
  }

  const toml::table& table_;
  std::string shown_;
  const std::filesystem::path& file_;
  std::set<std::string> known_;
};

std::optional<PulseShape> shape_named(std::string_view text) {
  constexpr std::array<std::string_view, 5> names = {"ricker", "ormsby", "harmonic", "tapered_sine",
                                                     "centrifuge"};
  const auto found = std::ranges::find(names, text);
  if (found == names.end())
    return std::nullopt;
  return static_cast<PulseShape>(found - names.begin());
}

/// Only the keys of its shape: another one is unknown there.
Pulse pulse(Keys& keys) {
  Pulse result{.shape = keys.word("shape", shape_named),
               .amplitude = keys.number("amplitude"),
               .time = keys.number("time")};
  if (result.shape == PulseShape::ormsby) {
    result.corners = keys.numbers<4>("corners");
    return result;
  }
  result.frequency = keys.number("frequency");
  if (result.shape == PulseShape::ricker)
    return result;
  result.cycles = keys.number("cycles");
  if (result.shape == PulseShape::harmonic)
    return result;
  result.ramp_cycles = keys.number("ramp_cycles");
  if (result.shape == PulseShape::centrifuge)
    result.third_harmonic = keys.number("third_harmonic", 0.0);
  return result;
}

SynthesisTarget target(Keys keys) {
  const SynthesisTarget result{.pga = keys.number("pga"),
                               .pgv = keys.number("pgv"),
                               .arias = keys.number("arias"),
                               .significant_duration = keys.number("duration"),
                               .mean_period = keys.number("mean_period"),
                               .tolerance = keys.number("tolerance", SynthesisTarget{}.tolerance)};
  keys.finish();
  return result;
}

SynthesisFilter filter(Keys keys) {
  const SynthesisFilter usual;
  const SynthesisFilter result{.frequency = keys.number("frequency"),
                               .damping = keys.number("damping", usual.damping),
                               .high_pass = keys.number("high_pass"),
                               .high_pass_damping = keys.number("high_pass_damping", usual.high_pass_damping),
                               .taper_start = keys.number("taper_start"),
                               .last_frequency = keys.number("last_frequency")};
  keys.finish();
  return result;
}

SynthesisEnvelope envelope(Keys keys) {
  const SynthesisEnvelope usual;
  const SynthesisEnvelope result{.start = keys.number("start", usual.start),
                                 .shape = keys.number("shape", usual.shape),
                                 .time = keys.number("time"),
                                 .burst_time = keys.number("burst_time"),
                                 .burst_width = keys.number("burst_width", usual.burst_width),
                                 .burst = keys.number("burst")};
  keys.finish();
  return result;
}

Recipe recipe(Keys keys) {
  Recipe result;
  if (keys.has("title"))
    result.title = keys.text("title");
  if (keys.has("kind"))
    result.kind = keys.word("kind", kind_named);
  const double dt = keys.number("dt");
  const auto count = static_cast<std::size_t>(keys.whole("samples", static_cast<std::int64_t>(most_samples)));
  if (keys.has("pulse")) {
    Keys inner = keys.table("pulse");
    PulseRecipe made{.pulse = pulse(inner), .unit = inner.word("unit", unit_named), .dt = dt, .count = count};
    inner.finish();
    result.what = made;
  } else {
    constexpr std::int64_t most_seed = 4294967295;
    constexpr std::int64_t most_seeds = 100000;
    result.what =
        SynthesisRecipe{.seed = static_cast<std::uint32_t>(keys.whole("seed", most_seed)),
                        .seeds = static_cast<int>(keys.whole("seeds", most_seeds, SynthesisRecipe{}.seeds)),
                        .dt = dt,
                        .count = count,
                        .target = target(keys.table("target")),
                        .filter = filter(keys.table("filter")),
                        .envelope = envelope(keys.table("envelope"))};
  }
  keys.finish();
  return result;
}

} // namespace

Recipe read_recipe(const std::filesystem::path& file) {
  constexpr std::uintmax_t longest_recipe = 1U << 20U; // bytes
  if (const auto why = why_unreadable(file); !why.empty())
    throw RecordError(fmt::format("{}: {}", file.string(), why));
  std::ifstream stream(file, std::ios::binary);
  if (std::filesystem::file_size(file) > longest_recipe)
    throw RecordError(
        fmt::format("{}: more than {} bytes, no recipe of a motion", file.string(), longest_recipe));
  return parse_recipe(stream, file);
}

Recipe parse_recipe(std::istream& stream, const std::filesystem::path& file) {
  try {
    const toml::table table = toml::parse(stream, file.string());
    return recipe({table, "the file", file});
  } catch (const toml::parse_error& error) {
    refuse(file, error.source().begin.line, printable_line(error.description()));
  }
}

} // namespace tremolo::motion
