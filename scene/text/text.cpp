#include "scene/text/text.hpp"

#include "base/text/printable.hpp"
#include "base/text/unreadable.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

namespace tremolo::scene {

namespace {

/// toml++ and all that walks its tables recurse into a key a.b.c...: far more parts than any file needs end
/// in a full stack.
constexpr std::size_t most_parts = 100;

/// Refuses a line with a bare key of too many parts. Dots in strings are none of a key's.
void refuse_deep_keys(std::string_view text, Findings& findings) {
  unsigned line = 1;
  std::size_t dots = 0;
  char quote = '\0';
  bool comment = false;
  for (const char c : text) {
    if (c == '\n') {
      ++line;
      dots = 0;
      quote = '\0';
      comment = false;
    } else if (comment) {
      continue;
    } else if (quote != '\0') {
      quote = c == quote ? '\0' : quote;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#') {
      comment = true;
    } else if (c == ',' || c == '=' || c == '{' || c == '[') {
      dots = 0;
    } else if (c == '.' && ++dots == most_parts) {
      findings.add("", Place{line, 1, ""}, fmt::format("a key of more than {} parts", most_parts));
      findings.throw_if_any();
    }
  }
}

} // namespace

toml::table parse_toml(std::string_view text, Findings& findings) {
  refuse_deep_keys(text, findings);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const auto begin = error.source().begin;
    findings.add("", Place{begin.line, begin.column, ""},
                 fmt::format("not valid TOML: {}", printable_line(error.description())));
    findings.throw_if_any();
    throw;
  }
}

std::string read_text(const std::filesystem::path& file) {
  if (const auto why = why_unreadable(file); !why.empty())
    throw CaseErrors({{file.string(), 1, 1, "", why}});
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return std::move(text).str();
}

} // namespace tremolo::scene
