#pragma once

// Damaged TOML files, read by whatever reads them.

#include "scene/text/errors.hpp"
#include "tests/support/text_mutator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

namespace tremolo::scene::testing {

using namespace std::string_view_literals;

/// More parts than a key may have.
inline constexpr std::string_view deep_key =
    "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a."
    "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a."
    "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a = 1\n";

inline constexpr std::array tokens = {"nan"sv,
                                      "-inf"sv,
                                      "1e308"sv,
                                      "-1"sv,
                                      "0"sv,
                                      "1e-300"sv,
                                      "99999999999999999999"sv,
                                      "9007199254740993"sv,
                                      "-9223372036854775808"sv,
                                      "1e-12"sv,
                                      "1e9"sv,
                                      deep_key,
                                      "\"\""sv,
                                      "\"x\""sv,
                                      "[]"sv,
                                      "[[]]"sv,
                                      "{}"sv,
                                      "{ a = 1 }"sv,
                                      "true"sv,
                                      "1979-05-27"sv,
                                      "["sv,
                                      "]"sv,
                                      "="sv,
                                      "\n"sv,
                                      "\""sv,
                                      "[mesh]\n"sv,
                                      "[[region]]\n"sv,
                                      "[[structure]]\n"sv,
                                      "[soil.sand]\n"sv,
                                      "polygon"sv,
                                      "\xff"sv,
                                      "\0"sv,
                                      "#"sv,
                                      "[[1,2],[3,4],[1,2]]"sv};

/// Damages a file's text again and again: each is read, or refused with located errors, and both come about.
/// @param read  reads a text and uses what came of it
/// @param least  share of texts that must be read: what is left of comments is harmless, dense text hardly
/// ever
template <class Read>
void expect_read_or_refused(const std::string& path, unsigned seed, std::size_t rounds, Read&& read,
                            double least = 0.05) {
  std::ifstream stream(path);
  std::ostringstream original;
  original << stream.rdbuf();
  ASSERT_FALSE(original.str().empty()) << path;
  tremolo::testing::TextMutator mutate(seed, tokens);
  std::size_t good = 0;
  for (std::size_t i = 0; i < rounds; ++i) {
    const std::string text = mutate(original.str());
    try {
      read(text);
      ++good;
    } catch (const CaseErrors& errors) {
      EXPECT_FALSE(errors.errors().empty());
      for (const Finding& error : errors.errors())
        EXPECT_FALSE(error.text.empty());
    } catch (const std::exception& error) {
      FAIL() << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(static_cast<double>(good), least * static_cast<double>(rounds));
  EXPECT_GT(rounds - good, rounds / 20);
}

} // namespace tremolo::scene::testing
