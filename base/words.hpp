#pragma once

// Enumerations whose values have words in files. Each has one table, a function beside it in its own
// namespace,
//
//     enum class Wave { sv, p };
//     constexpr auto words(Wave) { return word_table<Wave>({{Wave::sv, "SV"}, {Wave::p, "P"}}); }
//
// from which everything follows: the names in messages and reports, the words that a file may have, the order
// in which references list them, and the value that a word stands for. The argument of words() only chooses
// the table.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tremolo {

template <class Enum>
struct Word {
  Enum value;
  std::string_view word;
};

/// The table of an enumeration.
template <class Enum, std::size_t N>
constexpr std::array<Word<Enum>, N> word_table(const Word<Enum> (&entries)[N]) {
  return std::to_array(entries);
}

/// An enumeration with a table.
template <class Enum>
concept Worded = std::is_enum_v<Enum> && requires {
  words(Enum{});
};

/// The word of a value.
template <Worded Enum>
constexpr std::string_view name(Enum value) {
  for (const auto& [one, word] : words(value))
    if (one == value)
      return word;
  return {};
}

/// The value of a word; nothing for one that is not in the table.
template <Worded Enum>
constexpr std::optional<Enum> value_named(std::string_view text) {
  for (const auto& [value, word] : words(Enum{}))
    if (word == text)
      return value;
  return std::nullopt;
}

/// All words in the order of the table.
template <Worded Enum>
std::vector<std::string_view> all_words() {
  std::vector<std::string_view> all;
  for (const auto& [value, word] : words(Enum{}))
    all.push_back(word);
  return all;
}

} // namespace tremolo
