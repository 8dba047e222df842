#include "scene/soils/soil_library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tremolo::scene {

namespace {

/// Texts parsed, and the views of them.
struct Library {
  std::vector<toml::table> files;
  std::vector<LibrarySoil> soils;

  Library() {
    files.reserve(library_texts().size()); // the views stay valid
    for (const auto& [name, text] : library_texts()) {
      const toml::table& file = files.emplace_back(toml::parse(text, std::string(name)));
      const auto line = [&](std::string_view key) { return file[key].value_or(std::string_view{}); };
      soils.push_back({name, line("title"), line("source"), line("basis"), file["soil"].as_table()});
      if (soils.back().keys == nullptr)
        throw std::logic_error(fmt::format("the library's '{}' has no [soil]", name));
    }
    std::ranges::sort(soils, {}, &LibrarySoil::name);
  }
};

} // namespace

std::span<const LibrarySoil> soil_library() {
  static const Library library;
  return library.soils;
}

const LibrarySoil* library_soil(std::string_view name) {
  const auto found = std::ranges::find(soil_library(), name, &LibrarySoil::name);
  return found == soil_library().end() ? nullptr : &*found;
}

std::vector<std::string_view> library_names() {
  std::vector<std::string_view> names;
  for (const LibrarySoil& soil : soil_library())
    names.push_back(soil.name);
  return names;
}

} // namespace tremolo::scene
