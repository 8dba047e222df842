#include "motion/formats/formats.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace tremolo::motion {

namespace {

/// SAC: the version of the header, 6 or 7, is its 77th word, in either order of bytes.
bool is_sac(std::string_view head) {
  constexpr std::size_t word = 304;
  if (head.size() < word + 4)
    return false;
  const std::string_view version = head.substr(word, 4);
  return std::ranges::any_of(std::array{'\6', '\7'}, [&](char number) {
    return version == std::string{number, '\0', '\0', '\0'} ||
           version == std::string{'\0', '\0', '\0', number};
  });
}

/// miniSEED: a record number of six digits and a mark of quality before binary fields, or "MS" and the
/// version 3.
bool is_mini_seed(std::string_view head) {
  if (head.substr(0, 3) == "MS\3")
    return true;
  return head.size() > 6 && head.substr(0, 48).find('\0') != std::string_view::npos &&
         std::ranges::all_of(head.substr(0, 6),
                             [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }) &&
         std::string_view("DRQM").find(head[6]) != std::string_view::npos;
}

} // namespace

std::string_view binary_format(std::string_view head) {
  return is_sac(head) ? "SAC" : is_mini_seed(head) ? "miniSEED" : "";
}

} // namespace tremolo::motion
