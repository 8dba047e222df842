#pragma once

// Reading what another process has written: a key that is missing, or holds something else than it should, is
// that process's mistake and is reported in words, with the key and the value.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::coupler {

/// @throws Error for text that is no JSON, or is nested deeper than any message
nlohmann::json parsed_json(std::string_view text);

/// A value as it stands in a message, cut where it is long.
std::string shown(const nlohmann::json& value);

/// @throws Error for a key that is missing, as all of these
const nlohmann::json& value_at(const nlohmann::json& object, const char* key);

/// @throws Error for anything but an array
const nlohmann::json& list_at(const nlohmann::json& object, const char* key);

/// @throws Error for anything but a string
std::string text_at(const nlohmann::json& object, const char* key);

/// @returns fallback if the key is missing
std::string text_or(const nlohmann::json& object, const char* key, const std::string& fallback);

/// @throws Error for anything but a number
double number_at(const nlohmann::json& object, const char* key);

/// @throws Error for anything but an array of numbers
std::vector<double> numbers_at(const nlohmann::json& object, const char* key);

/// @throws Error for anything but a whole number that is not negative; 2000.0 is one, 2000.5 and -1 are not
std::uint64_t whole_at(const nlohmann::json& object, const char* key);

/// @throws Error as whole_at, and for what has no room in 32 bits
std::uint32_t whole_32_at(const nlohmann::json& object, const char* key);

} // namespace tremolo::coupler
