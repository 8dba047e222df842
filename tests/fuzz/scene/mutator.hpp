#pragma once

// Damage done to texts of TOML files, drawn from a seeded generator.

#include <algorithm>
#include <array>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <string_view>

namespace tremolo::scene::testing {

inline constexpr std::array<std::string_view, 28> tokens = {"nan",
                                                            "-inf",
                                                            "1e308",
                                                            "-1",
                                                            "0",
                                                            "1e-300",
                                                            "99999999999999999999",
                                                            "\"\"",
                                                            "\"x\"",
                                                            "[]",
                                                            "[[]]",
                                                            "{}",
                                                            "{ a = 1 }",
                                                            "true",
                                                            "1979-05-27",
                                                            "[",
                                                            "]",
                                                            "=",
                                                            "\n",
                                                            "\"",
                                                            "[mesh]\n",
                                                            "[[region]]\n",
                                                            "[soil.sand]\n",
                                                            "polygon",
                                                            "\xff",
                                                            "\0",
                                                            "#",
                                                            "[[1,2],[3,4],[1,2]]"};

class Mutator {
public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string operator()(std::string text) {
    for (std::size_t n = 1 + below(3); n > 0; --n)
      mutate(text);
    return text;
  }

private:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  void mutate(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(text.size() - at, below(30));
    switch (below(6)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
      text.insert(at, tokens[below(tokens.size())]);
      break;
    case 2:
      text.insert(below(text.size() + 1), text.substr(at, length));
      break;
    case 3:
      if (at < text.size())
        text[at] = static_cast<char>(below(256));
      break;
    default:
      replace_value(text, at);
    }
  }

  /// Puts a token in the place of what stands behind the next '='.
  void replace_value(std::string& text, std::size_t from) {
    const auto equals = text.find('=', from);
    if (equals == std::string::npos)
      return;
    const auto end = text.find_first_of(",}\n", equals);
    text.replace(equals + 1, end == std::string::npos ? end : end - equals - 1, tokens[below(tokens.size())]);
  }

  std::mt19937 random_;
};

inline std::string file_text(const std::string& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

} // namespace tremolo::scene::testing
