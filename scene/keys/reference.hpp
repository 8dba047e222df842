#pragma once

#include "scene/keys/keys.hpp"

#include <span>
#include <string>
#include <string_view>

namespace tremolo::scene {

/// The generated reference of a kind of file.
struct Reference {
  std::string_view page;   ///< file name of the page, in docs/
  std::string_view schema; ///< file name of the JSON schema beside it
  std::string_view title;  ///< of the schema
  std::string_view introduction;
  KeyTable keys;
};

std::span<const Reference> references();

/// The page in Markdown.
std::string markdown(const Reference& reference);

/// The JSON schema (draft 7), for editors that complete and check TOML.
std::string json_schema(const Reference& reference);

} // namespace tremolo::scene
