#include "scene/rules/result_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace tremolo::scene {

namespace {

/// Bytes beyond ASCII are letters of UTF-8.
bool is_plain(const std::string& name) {
  const auto letter = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
  };
  return letter(name.front()) && std::ranges::all_of(name, [&](char c) {
           return letter(c) || c == '_' || c == '-' || c == '+' || c == '.' || c == ' ';
         });
}

} // namespace

void check_result_names(std::string_view table, const std::vector<NamedResult>& named, Findings& findings) {
  for (std::size_t i = 0; i < named.size(); ++i) {
    const std::string& name = named[i].name;
    const std::string path = named[i].path + ".name";
    if (!name.empty() && !is_plain(name))
      findings.add(path,
                   fmt::format("'name' = \"{}\" names a table in the results and a picture: letters, digits, "
                               "blanks and _ - + . are allowed, beginning with a letter or digit",
                               name));
    const auto first = std::ranges::find(named, name, &NamedResult::name);
    if (!name.empty() && first - named.begin() < static_cast<std::ptrdiff_t>(i))
      findings.add(path, fmt::format("'name' = \"{}\" is taken by the {} in line {}", name, table,
                                     findings.place(first->path + ".name").line));
  }
}

} // namespace tremolo::scene
