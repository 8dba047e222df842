#pragma once

// Damage done to texts, drawn from a seeded generator.

#include <algorithm>
#include <cstddef>
#include <random>
#include <span>
#include <string>
#include <string_view>

namespace tremolo::testing {

/// Numbers below a bound, the same on every machine with the same library.
class Draw {
public:
  explicit Draw(unsigned seed) : random_(seed) {}

  /// 0 ... n - 1
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

private:
  std::mt19937 random_;
};

/// Does one to four things to a text: something is lost, a token appears, a piece is doubled, a byte changes,
/// or a token takes the place of a piece or of the value behind a '='.
class TextMutator {
public:
  /// @param tokens words and signs that the reader of the text knows, or stumbles over
  TextMutator(unsigned seed, std::span<const std::string_view> tokens) : draw_(seed), tokens_(tokens) {}

  std::string operator()(std::string text) {
    for (std::size_t n = 1 + draw_.below(4); n > 0; --n)
      mutate(text);
    return text;
  }

private:
  std::string_view token() { return tokens_[draw_.below(tokens_.size())]; }

  void mutate(std::string& text) {
    const std::size_t at = draw_.below(text.size() + 1);
    const std::size_t length = std::min(text.size() - at, draw_.below(30));
    switch (draw_.below(6)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
      text.insert(at, token());
      break;
    case 2:
      text.insert(draw_.below(text.size() + 1), text.substr(at, length));
      break;
    case 3:
      if (at < text.size())
        text[at] = static_cast<char>(draw_.below(256));
      break;
    case 4:
      text.replace(at, length, token());
      break;
    default:
      replace_value(text, at);
    }
  }

  void replace_value(std::string& text, std::size_t from) {
    const auto equals = text.find('=', from);
    if (equals == std::string::npos)
      return;
    const auto end = text.find_first_of(",}\n", equals);
    text.replace(equals + 1, end == std::string::npos ? end : end - equals - 1, token());
  }

  Draw draw_;
  std::span<const std::string_view> tokens_;
};

} // namespace tremolo::testing
