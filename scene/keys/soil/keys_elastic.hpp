#pragma once

#include "base/words.hpp"
#include "scene/keys/keys.hpp"

#include <optional>

namespace tremolo::scene {

/// density and either young + poisson or vs + vp: how every table that describes an elastic soil gives it.
std::vector<Key> elastic_keys();

/// `keys` with the elastic ones in front.
std::vector<Key> with_elastic_keys(std::vector<Key> keys);

/// The key of a choice.
Key choice(std::string_view name, std::vector<std::string_view> choices, std::string_view meaning,
           std::string_view fallback = {});

/// The key of a choice between the words of an enumeration; required without a fallback.
template <Worded Enum>
Key choice(std::string_view key, std::string_view meaning, std::optional<Enum> fallback = std::nullopt) {
  return choice(key, all_words<Enum>(), meaning, fallback ? name(*fallback) : std::string_view());
}

} // namespace tremolo::scene
