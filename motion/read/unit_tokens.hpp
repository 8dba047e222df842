#pragma once

// The words, numbers and signs of a text that may name a unit.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::motion {

struct UnitToken {
  enum class Kind { word, number, sign, open, close };

  Kind kind = Kind::word;
  std::string text;   ///< words in lower case; signs are * ^ / %
  double value = 0.0; ///< of a number
  std::size_t at = 0; ///< in the text
  bool glued = false; ///< nothing stands between it and the one before

  bool is(std::string_view what) const { return (kind == Kind::word || kind == Kind::sign) && text == what; }
  bool is_number() const { return kind == Kind::number; }
};

/// "**" and raised digits become ^, a raised dot and a cross *; "cm_s2" comes out as cm / s 2. A minus
/// belongs to the digit behind it; other dashes, points and commas separate.
std::vector<UnitToken> unit_tokens(std::string_view text);

} // namespace tremolo::motion
