#pragma once

// The grammar of units (motion/read/units.hpp) over the tokens of a text.

#include "motion/read/unit_tokens.hpp"
#include "motion/record.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace tremolo::motion {

/// A unit, and the number of the token behind it.
struct UnitAt {
  ScaledUnit unit;
  std::size_t end = 0;
};

/// The unit that begins at a token; nothing if none does.
std::optional<UnitAt> unit_at(std::span<const UnitToken> tokens, std::size_t begin);

/// "percent", "milli" and the like.
bool is_factor_word(const UnitToken& token);

/// "s", "sec", ...
bool is_second(const UnitToken& token);

template <std::size_t N>
bool is_one_of(const UnitToken& token, const std::array<std::string_view, N>& words) {
  return token.kind == UnitToken::Kind::word && std::ranges::find(words, token.text) != words.end();
}

/// A word and its meaning.
struct UnitWord {
  std::string_view text;
  double value;
};

template <std::size_t N>
std::optional<double> value_of(const UnitToken& token, const std::array<UnitWord, N>& words) {
  const auto found = std::ranges::find(words, token.text, &UnitWord::text);
  if (token.kind != UnitToken::Kind::word || found == words.end())
    return std::nullopt;
  return found->value;
}

} // namespace tremolo::motion
