#include "scene/keys/soil/keys_elastic.hpp"

#include "materials/elastic/elastic_parameters.hpp"
#include "scene/keys/soil/keys_law.hpp"

namespace tremolo::scene {

std::vector<Key> elastic_keys() {
  std::vector<Key> keys;
  for (const materials::Parameter& constant : materials::elastic_constants)
    keys.push_back(key_of(constant));
  return keys;
}

std::vector<Key> with_elastic_keys(std::vector<Key> keys) {
  auto all = elastic_keys();
  all.insert(all.end(), keys.begin(), keys.end());
  return all;
}

Key choice(std::string_view name, std::vector<std::string_view> choices, std::string_view meaning,
           std::string_view fallback) {
  return {.name = name,
          .type = Type::choice,
          .meaning = meaning,
          .required = fallback.empty(),
          .fallback = fallback,
          .choices = std::move(choices)};
}

} // namespace tremolo::scene
