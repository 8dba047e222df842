#include "scene/text/text.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

namespace tremolo::scene {

toml::table parse_toml(std::string_view text, Findings& findings) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const auto begin = error.source().begin;
    findings.add("", Place{begin.line, begin.column, ""},
                 fmt::format("not valid TOML: {}", error.description()));
    findings.throw_if_any();
    throw;
  }
}

std::string read_text(const std::filesystem::path& file) {
  std::error_code trouble;
  std::ifstream stream(file, std::ios::binary);
  if (!std::filesystem::is_regular_file(file, trouble) || !stream)
    throw CaseErrors(
        {{file.string(), 1, 1, "",
          std::filesystem::exists(file, trouble) ? "cannot be read: not a regular file, or no permission"
                                                 : "there is no such file"}});
  std::ostringstream text;
  text << stream.rdbuf();
  return std::move(text).str();
}

} // namespace tremolo::scene
