#include "motion/read/unit_grammar.hpp"

#include <cmath>

namespace tremolo::motion {

namespace {

using Kind = UnitToken::Kind;
using Word = UnitWord;

/// Words that scale the unit behind them.
constexpr std::array<Word, 14> factor_words = {{{"percent", 1e-2},
                                                {"pct", 1e-2},
                                                {"permille", 1e-3},
                                                {"centi", 1e-2},
                                                {"milli", 1e-3},
                                                {"micro", 1e-6},
                                                {"tenth", 1e-1},
                                                {"tenths", 1e-1},
                                                {"hundredth", 1e-2},
                                                {"hundredths", 1e-2},
                                                {"thousandth", 1e-3},
                                                {"thousandths", 1e-3},
                                                {"fraction", 1.0},
                                                {"fractions", 1.0}}};

/// Factors on g.
constexpr std::array<Word, 7> parts_of_g = {
    {{"g", 1.0}, {"mg", 1e-3}, {"millig", 1e-3}, {"ug", 1e-6}, {"microg", 1e-6}, {"cg", 1e-2}, {"dg", 1e-1}}};

/// Factors on cm/s2.
constexpr std::array<Word, 5> gals = {
    {{"gal", 1.0}, {"gals", 1.0}, {"mgal", 1e-3}, {"milligal", 1e-3}, {"milligals", 1e-3}}};

/// Lengths in m.
constexpr std::array<Word, 20> lengths = {{{"m", 1.0},           {"meter", 1.0},        {"meters", 1.0},
                                           {"metre", 1.0},       {"metres", 1.0},       {"cm", 1e-2},
                                           {"cms", 1e-2},        {"centimeter", 1e-2},  {"centimeters", 1e-2},
                                           {"centimetre", 1e-2}, {"centimetres", 1e-2}, {"mm", 1e-3},
                                           {"um", 1e-6},         {"nm", 1e-9},          {"ft", 0.3048},
                                           {"feet", 0.3048},     {"foot", 0.3048},      {"in", 0.0254},
                                           {"inch", 0.0254},     {"inches", 0.0254}}};

/// Reads tokens from `at` on.
class Reader {
public:
  Reader(std::span<const UnitToken> tokens, std::size_t at) : tokens_(tokens), at_(at) {}

  std::size_t at() const { return at_; }

  /// The unit that begins here; nothing if none does.
  std::optional<ScaledUnit> unit() {
    const auto by = factor();
    if (!by)
      return std::nullopt;
    auto found = base();
    if (!found)
      return std::nullopt;
    found->factor *= *by;
    if (is("/") && is_number(1) && value(1) >= 1.0) {
      found->factor /= value(1);
      at_ += 2;
    }
    return found;
  }

private:
  bool is(std::string_view what, std::size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() && tokens_[at_ + ahead].is(what);
  }
  bool is_number(std::size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() && tokens_[at_ + ahead].is_number();
  }
  double value(std::size_t ahead = 0) const { return tokens_[at_ + ahead].value; }
  bool is_time(std::size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() && is_second(tokens_[at_ + ahead]);
  }
  bool skip(std::string_view what) {
    const bool found = is(what);
    at_ += found ? 1 : 0;
    return found;
  }

  /// 1 where there is none; nothing if one is not understood.
  std::optional<double> factor() {
    double by = 1.0;
    if ((is("x") || is("*")) && is_number(1))
      ++at_;
    if (is_number()) {
      by = value();
      ++at_;
      if ((is("^") || is("/")) && is_number(1)) {
        by = is("^") ? std::pow(by, value(1)) : by / value(1);
        at_ += 2;
      }
      if (!skip("*") && !skip("x"))
        skip("of");
    } else if (is("%") || (is("per") && is("cent", 1))) {
      by = 1e-2;
      at_ += is("%") ? 1 : 2;
      skip("of");
    } else if (at_ < tokens_.size()) {
      if (const auto word = value_of(tokens_[at_], factor_words)) {
        by = *word;
        ++at_;
        skip("of");
      }
    }
    constexpr double smallest = 1e-9;
    if (!(by >= smallest && by <= 1.0))
      return std::nullopt;
    return by;
  }

  std::optional<ScaledUnit> base() {
    if (at_ == tokens_.size())
      return std::nullopt;
    const UnitToken& token = tokens_[at_];
    if (const auto part = value_of(token, parts_of_g)) {
      ++at_;
      return ScaledUnit{Unit::g, *part};
    }
    if (const auto part = value_of(token, gals)) {
      ++at_;
      return ScaledUnit{Unit::cm_s2, *part};
    }
    const auto length = value_of(token, lengths);
    // "in" is a word of speech unless time follows.
    if (!length || (token.text == "in" && !is("/", 1)))
      return std::nullopt;
    ++at_;
    const auto power = per_time();
    if (!power)
      return std::nullopt;
    return of_length(*length, *power);
  }

  /// The power of time below a length, 0 for a displacement; nothing if it is not understood.
  std::optional<int> per_time() {
    const std::size_t product = is("*") ? 1 : 0;
    if (is_time(product)) {
      at_ += product + 1;
      skip("^");
      if (!is_number() || (value() != -1.0 && value() != -2.0))
        return std::nullopt;
      const int power = value() == -1.0 ? 1 : 2;
      ++at_;
      return power;
    }
    int power = 0;
    while (power < 2 && (is("/") || is("per"))) {
      const auto more = one_time();
      if (!more)
        return std::nullopt;
      power += *more;
    }
    if (power > 2)
      return std::nullopt;
    return power;
  }

  /// "/s", "/ s^2", "/(s^2)", "per second squared".
  std::optional<int> one_time() {
    ++at_;
    const bool bracket = at_ < tokens_.size() && tokens_[at_].kind == Kind::open;
    at_ += bracket ? 1 : 0;
    const bool square = skip("square");
    if (!is_time())
      return std::nullopt;
    ++at_;
    int power = 1;
    if (square || skip("squared")) {
      power = 2;
    } else if (is("^") || (is_number() && tokens_[at_].glued)) {
      skip("^");
      if (!is_number() || (value() != 1.0 && value() != 2.0))
        return std::nullopt;
      power = static_cast<int>(value());
      ++at_;
    }
    if (bracket) {
      if (at_ == tokens_.size() || tokens_[at_].kind != Kind::close)
        return std::nullopt;
      ++at_;
    }
    return power;
  }

  static ScaledUnit of_length(double length, int power) {
    constexpr std::array in_m = {Unit::m, Unit::m_s, Unit::m_s2};
    constexpr std::array in_cm = {Unit::cm, Unit::cm_s, Unit::cm_s2};
    const auto i = static_cast<std::size_t>(power);
    if (length == 1e-2)
      return {in_cm[i], 1.0};
    if (length == 1e-3 && power == 0)
      return {Unit::mm, 1.0};
    return {in_m[i], length};
  }

  std::span<const UnitToken> tokens_;
  std::size_t at_;
};

} // namespace

std::optional<UnitAt> unit_at(std::span<const UnitToken> tokens, std::size_t begin) {
  Reader reader(tokens, begin);
  const auto unit = reader.unit();
  if (!unit)
    return std::nullopt;
  return UnitAt{*unit, reader.at()};
}

bool is_factor_word(const UnitToken& token) {
  return value_of(token, factor_words).has_value();
}

bool is_second(const UnitToken& token) {
  constexpr std::array<std::string_view, 5> seconds = {"s", "sec", "secs", "second", "seconds"};
  return is_one_of(token, seconds);
}

} // namespace tremolo::motion
