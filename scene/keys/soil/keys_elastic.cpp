#include "scene/keys/soil/keys_elastic.hpp"

namespace tremolo::scene {

std::vector<Key> elastic_keys() {
  return {
      {.name = "density", .unit = "kg/m3", .meaning = "Mass density.", .required = true, .range = positive},
      {.name = "young",
       .unit = "Pa",
       .meaning = "Young's modulus; together with `poisson`.",
       .otherwise = "`vs`",
       .range = positive},
      {.name = "poisson",
       .unit = "1",
       .meaning = "Poisson's ratio; together with `young` or `vs`.",
       .otherwise = "`vs` and `vp`",
       .range = {.low = -1.0, .high = 0.5, .low_open = true, .high_open = true}},
      {.name = "vs",
       .unit = "m/s",
       .meaning = "Speed of shear waves; together with `vp` or `poisson`.",
       .otherwise = "`young`",
       .range = positive},
      {.name = "vp",
       .unit = "m/s",
       .meaning = "Speed of compression waves, above sqrt(4/3) `vs`; together with `vs`.",
       .otherwise = "`poisson`",
       .range = positive},
  };
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
