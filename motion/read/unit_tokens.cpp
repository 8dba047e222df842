#include "motion/read/unit_tokens.hpp"

#include "motion/read/text.hpp"

#include <array>
#include <cctype>
#include <utility>

namespace tremolo::motion {

namespace {

using Kind = UnitToken::Kind;

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Signs beyond ASCII, in UTF-8 and in Latin-1, and their meaning. A raised sign after a ^ means the sign itself.
struct Spelling {
  std::string_view from;
  char to;
  bool raised = false;
};

constexpr std::array spellings = {
    Spelling{"\u00b9", '1', true}, Spelling{"\u00b2", '2', true}, Spelling{"\u00b3", '3', true},
    Spelling{"\u2070", '0', true}, Spelling{"\u2074", '4', true}, Spelling{"\u2075", '5', true},
    Spelling{"\u2076", '6', true}, Spelling{"\u2077", '7', true}, Spelling{"\u2078", '8', true},
    Spelling{"\u2079", '9', true}, Spelling{"\u207b", '-', true}, Spelling{"\u2212", '-'},
    Spelling{"\u00d7", '*'},       Spelling{"\u00b7", '*'},       Spelling{"\u22c5", '*'},
    Spelling{"\u00b5", 'u'},       Spelling{"\u03bc", 'u'},       Spelling{"\xb2", '2', true},
    Spelling{"\xb3", '3', true},   Spelling{"\xd7", '*'},         Spelling{"\xb7", '*'},
    Spelling{"\xb5", 'u'},
};

/// A text in ASCII, and where each character stood.
struct Plain {
  std::string text;
  std::vector<std::size_t> at;

  void add(char c, std::size_t place) {
    text.push_back(c);
    at.push_back(place);
  }
};

Plain plain(std::string_view text) {
  Plain result;
  bool raised = false;
  for (std::size_t i = 0; i < text.size();) {
    const Spelling* found = nullptr;
    for (const Spelling& one : spellings)
      if (found == nullptr && text.substr(i).starts_with(one.from))
        found = &one;
    if (found != nullptr && found->raised && !raised)
      result.add('^', i);
    raised = found != nullptr && found->raised;
    result.add(found != nullptr ? found->to : text[i], i);
    i += found != nullptr ? found->from.size() : 1;
  }
  return result;
}

/// The end of the number that begins here; `begin` where there is none.
std::size_t number_end(std::string_view text, std::size_t begin) {
  std::size_t i = begin;
  if (i < text.size() && (text[i] == '-' || text[i] == '+'))
    ++i;
  std::size_t digits = 0;
  for (bool point = false; i < text.size(); ++i) {
    if (is_digit(text[i]))
      ++digits;
    else if (text[i] == '.' && !point && (digits > 0 || (i + 1 < text.size() && is_digit(text[i + 1]))))
      point = true;
    else
      break;
  }
  if (digits == 0)
    return begin;
  if (i < text.size() && (std::toupper(text[i]) == 'E' || std::toupper(text[i]) == 'D')) {
    std::size_t exponent = i + 1;
    if (exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+'))
      ++exponent;
    std::size_t end = exponent;
    while (end < text.size() && is_digit(text[end]))
      ++end;
    if (end > exponent)
      return end;
  }
  return i;
}

/// An underscore that stands for a stroke, as in "v_cm_s" and "a_m_s2".
bool is_stroke(const std::vector<UnitToken>& before, std::string_view after) {
  if (before.empty() || before.back().kind != Kind::word)
    return false;
  const std::string& word = before.back().text;
  return (word == "m" || word == "cm" || word == "mm") && after.starts_with('s') &&
         (after.size() == 1 || !is_letter(after[1]));
}

} // namespace

std::vector<UnitToken> unit_tokens(std::string_view original) {
  auto [text, place] = plain(original);
  for (char& c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  std::vector<UnitToken> tokens;
  std::size_t end = std::string::npos; // of the token before
  const auto add = [&](Kind kind, std::size_t begin, std::size_t next, std::string word, double value = 0.0) {
    tokens.push_back({kind, std::move(word), value, place[begin], begin == end});
    end = next;
  };
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    std::size_t next = i + 1;
    if (const std::size_t past = number_end(text, i); past > i) {
      next = past;
      const auto value = number(std::string_view(text).substr(i, next - i));
      add(value ? Kind::number : Kind::word, i, next, text.substr(i, next - i), value.value_or(0.0));
    } else if (is_letter(c) || static_cast<unsigned char>(c) >= 0x80) {
      while (next < text.size() && (is_letter(text[next]) || static_cast<unsigned char>(text[next]) >= 0x80))
        ++next;
      add(Kind::word, i, next, text.substr(i, next - i));
    } else if (c == '*' && text.substr(i).starts_with("**")) {
      ++next;
      add(Kind::sign, i, next, "^");
    } else if (c == '*' || c == '^' || c == '/' || c == '%') {
      add(Kind::sign, i, next, std::string(1, c));
    } else if (c == '_' && is_stroke(tokens, std::string_view(text).substr(next))) {
      add(Kind::sign, i, next, "/");
    } else if (c == '(' || c == '[' || c == '{') {
      add(Kind::open, i, next, "(");
    } else if (c == ')' || c == ']' || c == '}') {
      add(Kind::close, i, next, ")");
    } else if (std::string_view("&?!$@<>|\\'").find(c) != std::string_view::npos) {
      add(Kind::word, i, next, std::string(1, c));
    }
    i = next;
  }
  return tokens;
}

} // namespace tremolo::motion
