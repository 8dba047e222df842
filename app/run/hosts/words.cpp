#include "app/run/hosts/words.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace tremolo::app {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::filesystem::path on_path(const std::string& program) {
  std::istringstream folders(environment("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const auto file = std::filesystem::path(folder) / program; ::access(file.c_str(), X_OK) == 0)
      return file;
  return {};
}

std::string found_on_path(const std::string& program) {
  if (const auto file = on_path(program); !file.empty())
    return file.string();
  throw std::runtime_error(
      fmt::format("[hosts] asks for {}, which is not on this machine's PATH: install it", program));
}

Words words_of(const std::string& text) {
  std::istringstream stream(text);
  Words words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  return words;
}

Words joined(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

} // namespace tremolo::app
