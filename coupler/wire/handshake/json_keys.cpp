#include "coupler/wire/handshake/json_keys.hpp"

#include "base/text/printable.hpp"
#include "coupler/wire/error.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tremolo::coupler {

using nlohmann::json;

namespace {

[[noreturn]] void refuse(const char* key, const json& value, std::string_view expected) {
  throw Error(fmt::format("'{}' is {}, expected {}", key, shown(value), expected));
}

/// Far more than any message has. What copies or prints a value walks into it call by call: a stack holds no
/// half a million brackets.
constexpr int deepest = 32;

} // namespace

json parsed_json(std::string_view text) {
  const auto limited = [](int depth, json::parse_event_t /*event*/, const json& /*parsed*/) {
    if (depth > deepest)
      throw Error(fmt::format("no JSON of ours: it is nested more than {} deep", deepest));
    return true;
  };
  try {
    return json::parse(text, limited);
  } catch (const json::parse_error& error) {
    throw Error(fmt::format("no JSON: it cannot be read at byte {} of {}", error.byte, text.size()));
  } catch (const json::out_of_range&) {
    throw Error("no JSON: it holds a number beyond the range of float64");
  }
}

std::string shown(const json& value) {
  constexpr std::size_t most = 60;
  return printable(value.dump(-1, ' ', false, json::error_handler_t::replace), most);
}

const json& value_at(const json& object, const char* key) {
  if (!object.is_object())
    throw Error(fmt::format("{} is no object with a key '{}'", shown(object), key));
  const auto value = object.find(key);
  if (value == object.end())
    throw Error(fmt::format("the key '{}' is missing", key));
  return *value;
}

const json& list_at(const json& object, const char* key) {
  const json& value = value_at(object, key);
  if (!value.is_array())
    refuse(key, value, "a list");
  return value;
}

std::string text_at(const json& object, const char* key) {
  const json& value = value_at(object, key);
  if (!value.is_string())
    refuse(key, value, "a text");
  return value.get<std::string>();
}

std::string text_or(const json& object, const char* key, const std::string& fallback) {
  return object.contains(key) ? text_at(object, key) : fallback;
}

double number_at(const json& object, const char* key) {
  const json& value = value_at(object, key);
  if (!value.is_number())
    refuse(key, value, "a number");
  return value.get<double>();
}

std::vector<double> numbers_at(const json& object, const char* key) {
  const json& list = list_at(object, key);
  std::vector<double> numbers;
  numbers.reserve(list.size());
  for (const json& value : list) {
    if (!value.is_number())
      refuse(key, list, fmt::format("numbers, but {} stands in it", shown(value)));
    numbers.push_back(value.get<double>());
  }
  return numbers;
}

std::uint64_t whole_at(const json& object, const char* key) {
  constexpr double exact_doubles = 9007199254740992.0; // 2^53
  const json& value = value_at(object, key);
  if (value.is_number_unsigned())
    return value.get<std::uint64_t>();
  // A language that knows one kind of numbers writes 2000.0.
  if (value.is_number_float())
    if (const auto number = value.get<double>();
        number >= 0.0 && number <= exact_doubles && number == std::floor(number))
      return static_cast<std::uint64_t>(number);
  refuse(key, value, "a whole number, 0 or more");
}

std::uint32_t whole_32_at(const json& object, const char* key) {
  const auto number = whole_at(object, key);
  if (number > std::numeric_limits<std::uint32_t>::max())
    refuse(key, object.at(key), fmt::format("{} at most", std::numeric_limits<std::uint32_t>::max()));
  return static_cast<std::uint32_t>(number);
}

} // namespace tremolo::coupler
