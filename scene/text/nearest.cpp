#include "scene/text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace tremolo::scene {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // d(i, j): distance of the first i characters of a from the first j of b (Damerau; optimal string
  // alignment).
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> d((a.size() + 1) * width);
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i * width + j] = i + j;
        continue;
      }
      const std::size_t replaced = d[(i - 1) * width + j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      std::size_t best = std::min({d[(i - 1) * width + j] + 1, d[i * width + j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        best = std::min(best, d[(i - 2) * width + j - 2] + 1);
      d[i * width + j] = best;
    }
  return d.back();
}

namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

/// A word that files no longer have, and what has taken its place.
struct Former {
  std::string_view word, now, why;
};
constexpr std::array former_words = {Former{"oblique", "fe", "whose column takes waves at an angle"}};

} // namespace

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
  if (known.empty())
    return "none is known here";
  for (const auto& [former, now, why] : former_words)
    if (word == former && std::ranges::find(known, now) != known.end())
      return fmt::format("it is '{}' now, {}", now, why);
  constexpr std::size_t longest_sensible_word = 64;
  // "sv" for "SV" is no other word, but a slip all the same.
  const std::string small = lower(word);
  const auto distance = [&](std::string_view other) { return edit_distance(small, lower(other)); };
  if (word.size() <= longest_sensible_word) {
    const auto nearest = std::ranges::min_element(known, {}, distance);
    if (distance(*nearest) <= std::max<std::size_t>(1, std::max(word.size(), nearest->size()) / 3))
      return fmt::format("did you mean '{}'?", *nearest);
  }
  return fmt::format("known: {}", fmt::join(known, ", "));
}

} // namespace tremolo::scene
