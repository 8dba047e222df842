#pragma once

// The library of soils: materials/library/*.toml, compiled into the program, so that a case which names a
// soil of it means the same wherever tremolo is installed.

#include <toml++/toml.h>

#include <span>
#include <string_view>
#include <vector>

namespace tremolo::scene {

/// The key of a soil's table that names a soil of the library.
inline constexpr std::string_view library_key = "library";

/// A file of the library as it stands.
struct LibraryText {
  std::string_view name; ///< the file's, without extension
  std::string_view text;
};

/// All files; made by the build.
std::span<const LibraryText> library_texts();

struct LibrarySoil {
  std::string_view name;
  std::string_view title;            ///< one line
  std::string_view source;           ///< where the values are from
  std::string_view basis;            ///< what of them is measured, and what is derived or assumed
  const toml::table* keys = nullptr; ///< those of a soil's table
};

/// All soils of the library, by name.
std::span<const LibrarySoil> soil_library();

/// nullptr for a name that is not in it
const LibrarySoil* library_soil(std::string_view name);

std::vector<std::string_view> library_names();

} // namespace tremolo::scene
