#pragma once

// What becomes of a small valid case when a piece of its text is replaced.

#include "scene/case.hpp"
#include "scene/text/errors.hpp"
#include "tests/support/flat_case.hpp"

#include <string>
#include <vector>

namespace tremolo::scene::testing {

using tremolo::testing::flat_case;
using tremolo::testing::plus;
using tremolo::testing::with;

inline Case parse_case(const std::string& text) {
  return parse(text, "case.toml", ".");
}

/// Messages of all errors; empty for a good case.
inline std::vector<std::string> errors_of(const std::string& text) {
  std::vector<std::string> messages;
  try {
    parse_case(text);
  } catch (const CaseErrors& errors) {
    for (const Finding& error : errors.errors())
      messages.push_back(error.message());
  }
  return messages;
}

/// Messages of the warnings and notes on a good case.
inline std::vector<std::string> remarks_of(const std::string& text) {
  std::vector<std::string> messages;
  for (const Finding& remark : parse_case(text).remarks)
    messages.push_back(remark.message());
  return messages;
}

} // namespace tremolo::scene::testing
